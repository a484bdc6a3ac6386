// Which wire is which button: what a configuration says about the pins and the input devices of a box, and
// what the backends "gpio" and "evdev" read. Names go first, numbers last: chips and event nodes change their
// numbers between boards and boots, the names of lines and devices do not.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// The resistor inside the chip that holds a line while nothing else does.
enum class Bias : std::uint8_t {
  kAsIs,  ///< as the firmware or the device tree left it
  kPullUp,
  kPullDown,
  kDisabled,
};

struct BiasName {
  Bias bias;
  std::string_view name;  ///< as a configuration spells it
};
inline constexpr std::array kBiasNames = std::to_array<BiasName>({{Bias::kAsIs, "as-is"},
                                                                  {Bias::kPullUp, "pull-up"},
                                                                  {Bias::kPullDown, "pull-down"},
                                                                  {Bias::kDisabled, "disabled"}});

/// What a contact may need to come to rest; good ones take 1 to 5 ms, tired ones up to 20 ms.
inline constexpr std::chrono::milliseconds kDefaultDebounce{10};

/// A button between a pin and ground (active_low, usually with a pull-up) or between a pin and supply.
struct GpioLine {
  std::string button;  ///< ButtonEvent::button
  std::string
      chip;  ///< label ("pinctrl-bcm2835"), name ("gpiochip0") or path; empty: look for the line's name
  std::string line;  ///< name ("GPIO17"), or offset in the chip ("17"), which needs `chip`
  bool active_low = false;
  Bias bias = Bias::kAsIs;
  std::chrono::milliseconds debounce = kDefaultDebounce;  ///< 0: none
};

/// A keyboard, a "gpio-keys" node, a rotary encoder: whatever shows up as an input event device.
struct EvdevDevice {
  /// Of the device as the kernel tells it ("gpio-keys"), or a path (/dev/input/by-path/...); empty: every
  /// device that looks like buttons.
  std::string name;
  /// Codes (KEY_NEXT, BTN_0) and steps of relative axes (REL_X+, REL_X-) to buttons. Empty: the keys of the
  /// simulated box.
  std::map<std::string, std::string> keys;
  bool grab = false;  ///< keep its keys from the console and everybody else
};

struct ButtonWiring {
  std::vector<GpioLine> gpio;
  std::vector<EvdevDevice> evdev;
};

}  // namespace vitrine
