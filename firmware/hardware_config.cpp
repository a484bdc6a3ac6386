#include "hardware_config.h"

#include <algorithm>
#include <set>

#include "actions.h"
#include "nearest_name.h"

namespace vitrine {
namespace {

/// The entries of `base` whose key none of `over` has, behind those of `over`.
template <class T, class Key>
std::vector<Placed<T>> merged(const std::vector<Placed<T>>& base, const std::vector<Placed<T>>& over,
                              const Key& key) {
  std::vector<Placed<T>> both = over;
  for (const Placed<T>& entry : base) {
    const auto same = [&](const Placed<T>& other) { return key(other.value) == key(entry.value); };
    if (std::ranges::none_of(over, same)) both.push_back(entry);
  }
  return both;
}

template <class T>
void take(std::optional<T>& value, const std::optional<T>& over) {
  if (over) value = over;
}

}  // namespace

ButtonWiring HardwareConfig::wiring() const {
  ButtonWiring wiring;
  for (const auto& line : gpio) wiring.gpio.push_back(line.value);
  for (const auto& device : evdev) wiring.evdev.push_back(device.value);
  return wiring;
}

std::vector<GestureRule> HardwareConfig::rules() const {
  std::vector<GestureRule> all;
  for (const auto& rule : gestures) all.push_back(rule.value);
  return all;
}

std::vector<std::string> HardwareConfig::wired_buttons() const {
  std::set<std::string> names;
  for (const auto& line : gpio) names.insert(line.value.button);
  for (const auto& device : evdev) {
    for (const auto& [code, button] : device.value.keys) names.insert(button);
  }
  return {names.begin(), names.end()};
}

HardwareConfig read_hardware(const std::filesystem::path& path, const toml::table& root) {
  return {.display = read_display(path, root),
          .gpio = read_gpio(path, root),
          .evdev = read_evdev(path, root),
          .gestures = read_gestures(path, root)};
}

HardwareConfig read_board(const std::filesystem::path& path) {
  const toml::table root = read_toml(path);
  require_known_keys(path, root, kHardwareKeys);
  return read_hardware(path, root);
}

HardwareConfig overlay(const HardwareConfig& base, const HardwareConfig& over) {
  HardwareConfig both = base;
  take(both.display.backend, over.display.backend);
  take(both.display.card, over.display.card);
  take(both.display.connector, over.display.connector);
  take(both.display.mode, over.display.mode);
  take(both.display.device, over.display.device);
  take(both.display.rotation, over.display.rotation);
  take(both.display.scaling, over.display.scaling);
  take(both.display.format, over.display.format);
  both.gpio = merged(base.gpio, over.gpio, [](const GpioLine& line) { return line.button; });
  both.evdev = merged(base.evdev, over.evdev, [](const EvdevDevice& device) { return device.name; });
  both.gestures = merged(base.gestures, over.gestures, [](const GestureRule& rule) {
    return std::pair(std::set(rule.buttons.begin(), rule.buttons.end()), rule.kind);
  });
  return both;
}

void require_consistent(const HardwareConfig& hardware) {
  std::vector<std::string> pressed = hardware.wired_buttons();
  for (const std::string& action : action_names()) pressed.push_back(action);
  std::set<std::string> ruled;
  for (const auto& [rule, file, place] : hardware.gestures) {
    for (const std::string& button : rule.buttons) {
      if (std::ranges::find(pressed, button) == pressed.end())
        throw toml_error(file, place, "no button is named '" + button + "'", name_remedy(button, pressed));
      ruled.insert(button);
    }
  }
  const auto require_use = [&](const std::string& button, const auto& at) {
    if (find_action(button) != nullptr || ruled.contains(button)) return;
    throw toml_error(
        at.file, at.place, "the button '" + button + "' does nothing",
        "add a [[gesture]] with it, or call it by an action: " + name_remedy(button, action_names()));
  };
  for (const auto& line : hardware.gpio) require_use(line.value.button, line);
  for (const auto& device : hardware.evdev) {
    for (const auto& [code, button] : device.value.keys) require_use(button, device);
  }
  const std::vector<GestureRule> rules = hardware.rules();
  for (std::size_t i = 0; i < rules.size(); ++i) {
    const std::string problem = rule_problem(rules, i);
    if (problem.empty()) continue;
    const std::size_t end = problem.find("; ");
    throw toml_error(hardware.gestures[i].file, hardware.gestures[i].place, problem.substr(0, end),
                     end == std::string::npos ? "correct this gesture" : problem.substr(end + 2));
  }
}

}  // namespace vitrine
