// What screens this machine has, as a person who wires a box needs to see it, and as the backends choose from
// it. Plain data: the backends fill it, each with what it knows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pixel_layout.h"

namespace vitrine {

struct ScreenMode {
  int width = 0;
  int height = 0;
  double refresh_hz = 0.0;
  bool preferred = false;  ///< by the screen itself
  bool interlaced = false;
};

/// As a configuration names it: "1920x1080@60".
[[nodiscard]] std::string mode_text(const ScreenMode& mode);

/// Whether a screen is plugged in; some panels cannot tell.
enum class Plugged : std::uint8_t { kNo, kUnknown, kYes };

/// An output of a KMS card.
struct ConnectorInfo {
  std::string name{};  ///< as the kernel names it: "HDMI-A-1"
  Plugged plugged = Plugged::kNo;
  std::vector<ScreenMode> modes{};
};

/// A KMS card.
struct CardInfo {
  std::string path{};                  ///< "/dev/dri/card0"
  std::string driver{};                ///< "vc4"
  std::string bus{};                   ///< where it sits: "pci 0000:00:02.0", "platform gpu"
  std::string problem{};               ///< why it cannot be used, one line with a remedy; empty: it can
  std::vector<std::string> formats{};  ///< of its memory that we can write: "XRGB8888", "RGB565"
  std::vector<ConnectorInfo> connectors{};
};

/// A framebuffer device.
struct FramebufferInfo {
  std::string path{};     ///< "/dev/fb0"
  std::string id{};       ///< its driver's name for it: "fb_ili9341"
  std::string problem{};  ///< why it cannot be used, one line with a remedy; empty: it can
  int width = 0;
  int height = 0;
  std::size_t stride_bytes = 0;
  PixelLayout layout{};
};

struct ScreenInventory {
  std::vector<CardInfo> cards{};
  std::vector<FramebufferInfo> framebuffers{};
};

}  // namespace vitrine
