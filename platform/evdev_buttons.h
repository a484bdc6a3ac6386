// Buttons that the kernel knows as input devices: keyboards, "gpio-keys" nodes, rotary encoders. Devices may
// come and go: once a second the backend looks what is new in /dev/input. That needs no daemon, works before
// one has set rights and links, and costs some stat() calls; a keyboard takes as long to wake up.
//
// What is held on a device that goes away is released. When the kernel had to drop events, the state of the
// keys is asked for: no release is lost.
#pragma once

#include <ctime>
#include <filesystem>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "button_wiring.h"
#include "buttons.h"
#include "input_devices.h"

namespace vitrine {

class EvdevButtons final : public Buttons {
 public:
  /// Without `devices`: every device that looks like buttons, with the keys of `buttons`. Throws
  /// std::runtime_error for names of keys that do not exist; devices that are not there are waited for.
  EvdevButtons(std::span<const EvdevDevice> devices, std::span<const ButtonSpec> buttons,
               std::filesystem::path folder = "/dev/input");

  std::vector<ButtonEvent> poll(std::chrono::milliseconds timeout) override;

  /// Which devices are waited for or cannot be opened.
  [[nodiscard]] std::string notice() const override;

 private:
  /// What the configuration says of a device.
  struct Wanted {
    EvdevDevice device;
    InputMap map;
  };
  struct Source {
    std::filesystem::path node;
    InputHandle handle;
    const Wanted* wanted;
    std::set<InputCode> held;
  };
  /// Tells whether a node is still the one that was looked at.
  struct Identity {
    unsigned long long inode;
    std::timespec changed;
    bool operator==(const Identity& other) const {
      return inode == other.inode && changed.tv_sec == other.changed.tv_sec &&
             changed.tv_nsec == other.changed.tv_nsec;
    }
  };

  void look_for_devices();
  void consider(const std::filesystem::path& node);
  [[nodiscard]] bool named_by_path(const std::filesystem::path& node) const;
  [[nodiscard]] const Wanted* wanted_as(const InputDevice& device) const;
  /// Whether the device is still there.
  static bool read(Source& source, std::vector<ButtonEvent>& events);
  static void take(Source& source, const InputCode& code, int value, Clock::time_point time,
                   std::vector<ButtonEvent>& events);
  static void release_all(Source& source, std::vector<ButtonEvent>& events);

  std::filesystem::path folder_;
  std::vector<Wanted> wanted_;
  std::list<Source> sources_;
  std::map<std::filesystem::path, Identity> known_;  ///< nodes that were looked at
  std::map<std::filesystem::path, std::string> problems_;
  Clock::time_point next_look_{};
};

}  // namespace vitrine
