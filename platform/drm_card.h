// A KMS card: its device file, what it says of itself, and the choice of the way from a buffer to a screen:
// which connector, which CRTC drives it, in which mode and format.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <xf86drmMode.h>

#include "display_options.h"
#include "drm_format.h"
#include "file_descriptor.h"
#include "screen_inventory.h"

namespace vitrine {

/// A way to a screen.
struct DrmPipe {
  std::uint32_t connector = 0;
  std::string connector_name{};
  std::uint32_t crtc = 0;
  drmModeModeInfo timing{};
  ScreenMode mode{};
  const DrmFormat* format = nullptr;
  std::string notice{};  ///< what of the options could not be had, or empty
};

/// Whether a connector's screen is looked for anew, which may take 100 ms, or told as last seen.
enum class Probe : std::uint8_t { kAnew, kLastSeen };

class DrmCard {
 public:
  /// Opens it. Throws DisplayUnavailable when that is refused, or when it has no outputs or no dumb buffers.
  explicit DrmCard(const std::filesystem::path& path);

  [[nodiscard]] int fd() const { return file_.get(); }
  /// Whether we may set modes: the right belongs to who opens the card first, until that one gives it up.
  [[nodiscard]] bool is_ours() const;
  /// Path, driver and bus alone.
  [[nodiscard]] CardInfo identity() const;
  [[nodiscard]] CardInfo describe(Probe probe) const;
  /// The way to the screen that the options mean, or none while there is no such screen.
  [[nodiscard]] std::optional<DrmPipe> choose_pipe(const DisplayOptions& options, Probe probe) const;

 private:
  struct Connector {
    std::uint32_t id = 0;
    std::vector<std::uint32_t> crtcs{};  // that can drive it, the best first
    std::vector<drmModeModeInfo> timings{};
    ConnectorInfo info{};
  };

  [[nodiscard]] std::vector<Connector> connectors(Probe probe) const;
  /// The format codes of a CRTC's primary plane.
  [[nodiscard]] std::vector<std::uint32_t> formats_of(std::uint32_t crtc) const;

  std::filesystem::path path_;
  FileDescriptor file_;
  std::string driver_;
  int preferred_bits_ = 0;
};

/// The device files of all cards, by number.
[[nodiscard]] std::vector<std::filesystem::path> drm_card_paths();

/// All cards with all they have, those that cannot be used with the reason.
[[nodiscard]] ScreenInventory list_drm_cards();

}  // namespace vitrine
