#include "input_devices.h"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <libevdev/libevdev.h>
#include <unistd.h>

#include "device_access.h"

namespace vitrine {
namespace {

constexpr unsigned kBusCec = 0x1e;  // BUS_CEC of newer kernel headers

bool is_remote_control(const InputDevice& device) {
  return device.bus == kBusCec || device.name.find("CEC") != std::string::npos ||
         device.name.find("cec") != std::string::npos;
}

bool is_pointer(const InputDevice& device) {
  const bool moves = (device.axes.contains(REL_X) && device.axes.contains(REL_Y)) ||
                     (device.positions.contains(ABS_X) && device.positions.contains(ABS_Y));
  const bool clicks =
      std::ranges::any_of(std::initializer_list<unsigned>{BTN_LEFT, BTN_TOUCH, BTN_TOOL_PEN, BTN_TOOL_FINGER},
                          [&](unsigned key) { return device.keys.contains(key); });
  return moves && clicks;
}

bool is_power_button(const InputDevice& device) {
  return std::ranges::all_of(device.keys, [](unsigned key) {
    return key == KEY_POWER || key == KEY_SLEEP || key == KEY_WAKEUP || key == KEY_SUSPEND ||
           key == KEY_POWER2;
  });
}

bool has(const InputDevice& device, const InputCode& code) {
  return (code.type == EV_KEY ? device.keys : device.axes).contains(code.code);
}

std::vector<std::string> names_of(const InputDevice& device) {
  std::vector<std::string> names;
  for (const unsigned key : device.keys) names.push_back(name_of({EV_KEY, key, 0}));
  for (const unsigned axis : device.axes) {
    names.push_back(name_of({EV_REL, axis, 1}));
    names.push_back(name_of({EV_REL, axis, -1}));
  }
  std::erase(names, std::string());
  return names;
}

std::vector<std::string> links_to(const std::filesystem::path& node) {
  std::vector<std::string> links;
  for (const char* folder : {"by-id", "by-path"}) {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(node.parent_path() / folder, error)) {
      std::error_code broken;
      if (std::filesystem::equivalent(entry.path(), node, broken)) links.push_back(entry.path().string());
    }
  }
  std::ranges::sort(links);
  return links;
}

}  // namespace

std::string why_unused(const InputDevice& device, const InputMap& map) {
  if (is_remote_control(device)) return "the remote control of the screen (CEC)";
  if (device.keys.empty() && device.axes.empty()) return "no keys and no steps";
  if (is_pointer(device)) return "a pointer";
  if (!device.keys.empty() && is_power_button(device)) return "the power button";
  if (std::ranges::any_of(map, [&](const auto& entry) { return has(device, entry.first); })) return "";
  return "none of its keys is one of the box's";
}

InputHandle::InputHandle(const std::filesystem::path& node)
    : node_(node), descriptor_(open(node.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), node.string());
  const int status = libevdev_new_from_fd(descriptor_, &evdev_);
  if (status < 0) {
    close(descriptor_);
    throw std::system_error(-status, std::generic_category(), node.string());
  }
}

InputHandle::~InputHandle() {
  libevdev_free(evdev_);
  if (descriptor_ >= 0) close(descriptor_);
}

InputHandle::InputHandle(InputHandle&& other) noexcept
    : node_(std::move(other.node_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      evdev_(std::exchange(other.evdev_, nullptr)) {}

InputDevice InputHandle::describe() const {
  InputDevice device;
  device.node = node_;
  device.name = libevdev_get_name(evdev_);
  device.bus = static_cast<unsigned>(libevdev_get_id_bustype(evdev_));
  const auto codes = [&](unsigned type, unsigned last) {
    std::set<unsigned> found;
    for (unsigned code = 0; code <= last; ++code) {
      if (libevdev_has_event_code(evdev_, type, code) == 1) found.insert(code);
    }
    return found;
  };
  device.keys = codes(EV_KEY, KEY_MAX);
  device.axes = codes(EV_REL, REL_MAX);
  device.positions = codes(EV_ABS, ABS_MAX);
  return device;
}

std::vector<std::filesystem::path> input_nodes(const std::filesystem::path& folder) {
  return numbered_nodes(folder, "event");
}

InputInventory find_input_devices(std::span<const ButtonSpec> buttons) {
  const InputMap map = input_map(buttons);
  InputInventory inventory;
  for (const std::filesystem::path& node : input_nodes()) {
    try {
      InputDevice device = InputHandle(node).describe();
      InputInventory::Found found{.device = {},
                                  .unused = why_unused(device, map),
                                  .codes = names_of(device),
                                  .links = links_to(node)};
      found.device = std::move(device);
      inventory.devices.push_back(std::move(found));
    } catch (const std::system_error& error) {
      inventory.problems.push_back(open_problem(node, error.code().value()));
    }
  }
  return inventory;
}

}  // namespace vitrine
