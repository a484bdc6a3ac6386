// Which of a machine's cards, connectors and modes to show on: by name where the configuration names one,
// otherwise by what they can do, and never by number alone, since numbers change from boot to boot.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "screen_inventory.h"

namespace vitrine {

/// A mode asked for.
struct ModeWish {
  int width = 0;
  int height = 0;
  std::optional<double> refresh_hz{};
};

/// Reads "1920x1080" or "1920x1080@60". Throws std::runtime_error, one line with a remedy.
[[nodiscard]] ModeWish parse_mode(std::string_view text);

/// The mode that fits the wish, at a rate within 1 Hz where it names one, or none; without a wish the one
/// that the screen prefers, or else its largest up to 1920x1080, or else its smallest. Interlaced modes come
/// last.
[[nodiscard]] std::optional<std::size_t> choose_mode(std::span<const ScreenMode> modes,
                                                     const std::optional<ModeWish>& wish);

/// The connector of that name, if a screen is plugged into it; without a name the first with a screen.
/// Connectors that cannot tell count as plugged when they have modes and no other is surely plugged.
[[nodiscard]] std::optional<std::size_t> choose_connector(std::span<const ConnectorInfo> connectors,
                                                          std::string_view name);

/// Whether `name` means this card: empty, its path (or a link to it), its driver or its place on the bus.
[[nodiscard]] bool is_meant(const CardInfo& card, const std::string& name);
/// Whether `name` means this framebuffer device: empty, its path (or a link to it) or its driver's id.
[[nodiscard]] bool is_meant(const FramebufferInfo& device, const std::string& name);

}  // namespace vitrine
