// The input devices of a machine, and which of them are buttons: a keyboard or a "gpio-keys" node is, a
// mouse, a remote control on the HDMI cable or the power button is not, unless the configuration names it.
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "input_codes.h"

struct libevdev;

namespace vitrine {

struct InputDevice {
  std::filesystem::path node;  ///< /dev/input/event3
  std::string name{};
  unsigned bus = 0;                ///< BUS_USB, ...
  std::set<unsigned> keys{};       ///< EV_KEY codes
  std::set<unsigned> axes{};       ///< EV_REL codes
  std::set<unsigned> positions{};  ///< EV_ABS codes
};

/// Why a device is not used unless it is named; empty: it is. `map` has the codes that matter.
[[nodiscard]] std::string why_unused(const InputDevice& device, const InputMap& map);

/// An open device.
class InputHandle {
 public:
  /// Throws std::system_error.
  explicit InputHandle(const std::filesystem::path& node);
  ~InputHandle();
  InputHandle(InputHandle&& other) noexcept;
  InputHandle& operator=(InputHandle&&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] libevdev* get() const { return evdev_; }
  [[nodiscard]] InputDevice describe() const;

 private:
  std::filesystem::path node_;
  int descriptor_;
  libevdev* evdev_ = nullptr;
};

/// The event nodes of a folder, in order.
[[nodiscard]] std::vector<std::filesystem::path> input_nodes(
    const std::filesystem::path& folder = "/dev/input");

struct InputInventory {
  struct Found {
    InputDevice device{};
    std::string unused{};              ///< why_unused()
    std::vector<std::string> codes{};  ///< names of keys and axis steps, as a configuration spells them
    std::vector<std::string> links{};  ///< stable paths, as /dev/input/by-path/...
  };
  std::vector<Found> devices;
  std::vector<std::string> problems;  ///< "PATH: REASON; REMEDY" of devices that could not be opened
};

/// `buttons` says which keys the box knows.
[[nodiscard]] InputInventory find_input_devices(std::span<const ButtonSpec> buttons);

}  // namespace vitrine
