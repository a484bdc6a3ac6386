// What a config file says about the hardware of a box: its screen, its wires, and what pressing its buttons
// does. A board file holds this and nothing else; the box's own file may name one, and goes first.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "button_wiring.h"
#include "display_options.h"
#include "gestures.h"
#include "strict_toml.h"

namespace vitrine {

/// The table `[display]`, or `display = "BACKEND"`; whatever is not given is left to the program.
struct DisplayConfig {
  std::optional<std::string> backend{};
  std::optional<std::string> card{};
  std::optional<std::string> connector{};
  std::optional<std::string> mode{};
  std::optional<std::string> device{};
  std::optional<int> rotation{};
  std::optional<Scaling> scaling{};
  std::optional<PixelFormat> format{};

  [[nodiscard]] DisplayOptions options() const;
  bool operator==(const DisplayConfig&) const = default;
};

/// A value and where it was written.
template <class T>
struct Placed {
  T value;
  std::filesystem::path file;
  toml::source_region place;
};

struct HardwareConfig {
  DisplayConfig display{};
  std::vector<Placed<GpioLine>> gpio{};
  std::vector<Placed<EvdevDevice>> evdev{};
  std::vector<Placed<GestureRule>> gestures{};

  [[nodiscard]] ButtonWiring wiring() const;
  [[nodiscard]] std::vector<GestureRule> rules() const;
  /// The names of the buttons that are wired, each once.
  [[nodiscard]] std::vector<std::string> wired_buttons() const;
};

/// The keys of a file that are about hardware.
inline const std::vector<std::string> kHardwareKeys{"display", "gpio", "evdev", "gesture"};

// All throw InputError.

DisplayConfig read_display(const std::filesystem::path& path, const toml::table& root);
std::vector<Placed<GpioLine>> read_gpio(const std::filesystem::path& path, const toml::table& root);
std::vector<Placed<EvdevDevice>> read_evdev(const std::filesystem::path& path, const toml::table& root);
std::vector<Placed<GestureRule>> read_gestures(const std::filesystem::path& path, const toml::table& root);

/// The tables above; other keys of `root` are not looked at.
HardwareConfig read_hardware(const std::filesystem::path& path, const toml::table& root);
/// A board file: nothing but those.
HardwareConfig read_board(const std::filesystem::path& path);

/// `over` where it says something about a key of the display, a button's pin, a device, a gesture; else
/// `base`.
HardwareConfig overlay(const HardwareConfig& base, const HardwareConfig& over);

/// Throws InputError for a wire to a button that does nothing, and for a gesture of a button that is not
/// there or that does not go with the others.
void require_consistent(const HardwareConfig& hardware);

}  // namespace vitrine
