#include "screen_choice.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <tuple>

namespace vitrine {
namespace {

/// How far a mode's rate may be from the one asked for: 59.94 Hz is what "60" means.
constexpr double kRateTolerance_hz = 1.0;
constexpr double kUsualRate_hz = 60.0;
constexpr int kMaxSide = 16384;
/// What any screen shows and a small board can fill, either way round.
constexpr int kUsualLongSide = 1920;
constexpr int kUsualShortSide = 1080;

template <class Number>
bool take_number(std::string_view& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc{};
}

bool take_sign(std::string_view& text, char sign) {
  if (!text.starts_with(sign)) return false;
  text.remove_prefix(1);
  return true;
}

/// Greater is better. A screen whose EDID prefers nothing may still list sizes that are not its pixels' and
/// that no board fills in time, such as 5120x2160: of these the largest is not what a person would take.
auto worth(const ScreenMode& mode) {
  const auto [short_side, long_side] = std::minmax(mode.width, mode.height);
  const bool large_is_good = mode.preferred || (short_side <= kUsualShortSide && long_side <= kUsualLongSide);
  const int area = mode.width * mode.height;
  return std::tuple(!mode.interlaced, mode.preferred, large_is_good, large_is_good ? area : -area,
                    -std::abs(mode.refresh_hz - kUsualRate_hz));
}

bool fits(const ScreenMode& mode, const ModeWish& wish) {
  return mode.width == wish.width && mode.height == wish.height &&
         (!wish.refresh_hz || std::abs(mode.refresh_hz - *wish.refresh_hz) <= kRateTolerance_hz);
}

/// Whether a name is a path, of a link perhaps, to the file.
bool leads_to(const std::string& name, const std::string& path) {
  std::error_code none;
  return name.starts_with('/') && std::filesystem::canonical(name, none) == path;
}

}  // namespace

std::string mode_text(const ScreenMode& mode) {
  char rate[32] = "";
  std::snprintf(rate, sizeof rate, "%.4g", mode.refresh_hz);
  return std::to_string(mode.width) + "x" + std::to_string(mode.height) + "@" + rate +
         (mode.interlaced ? " interlaced" : "");
}

ModeWish parse_mode(std::string_view text) {
  ModeWish wish;
  std::string_view rest = text;
  bool good = take_number(rest, wish.width) && take_sign(rest, 'x') && take_number(rest, wish.height);
  if (good && take_sign(rest, '@')) {
    double rate = 0.0;
    good = take_number(rest, rate) && rate >= 1.0 && rate <= 1000.0;
    wish.refresh_hz = rate;
  }
  if (!good || !rest.empty() || std::min(wish.width, wish.height) < 1 ||
      std::max(wish.width, wish.height) > kMaxSide) {
    throw std::runtime_error("'" + std::string(text) +
                             "' is no mode of a screen; write WIDTHxHEIGHT or WIDTHxHEIGHT@HZ, as in "
                             "1920x1080@60");
  }
  return wish;
}

std::optional<std::size_t> choose_mode(std::span<const ScreenMode> modes,
                                       const std::optional<ModeWish>& wish) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (wish && !fits(modes[i], *wish)) continue;
    if (!best || worth(modes[i]) > worth(modes[*best])) best = i;
  }
  return best;
}

std::optional<std::size_t> choose_connector(std::span<const ConnectorInfo> connectors,
                                            std::string_view name) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < connectors.size(); ++i) {
    const ConnectorInfo& connector = connectors[i];
    if ((!name.empty() && connector.name != name) || connector.plugged == Plugged::kNo) continue;
    if (connector.modes.empty()) continue;
    if (!best || connector.plugged > connectors[*best].plugged) best = i;
  }
  return best;
}

bool is_meant(const CardInfo& card, const std::string& name) {
  if (name.empty() || name == card.path || name == card.driver || name == card.bus) return true;
  return leads_to(name, card.path);
}

bool is_meant(const FramebufferInfo& device, const std::string& name) {
  return name.empty() || name == device.path || name == device.id || leads_to(name, device.path);
}

}  // namespace vitrine
