#include "input_codes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <libevdev/libevdev.h>

#include "nearest_name.h"

namespace vitrine {
namespace {

std::string code_name(unsigned type, unsigned code) {
  const char* const name = libevdev_event_code_get_name(type, code);
  return name == nullptr ? "" : name;
}

std::optional<InputCode> parse_code(const std::string& name) {
  const bool axis = name.ends_with('+') || name.ends_with('-');
  const unsigned type = axis ? EV_REL : EV_KEY;
  const std::string bare = axis ? name.substr(0, name.size() - 1) : name;
  const int code = libevdev_event_code_from_name(type, bare.c_str());
  if (code < 0) return std::nullopt;
  return InputCode{type, static_cast<unsigned>(code), axis ? (name.back() == '+' ? 1 : -1) : 0};
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (unsigned code = 0; code <= KEY_MAX; ++code) {
    if (std::string name = code_name(EV_KEY, code); !name.empty()) names.push_back(std::move(name));
  }
  for (unsigned code = 0; code <= REL_MAX; ++code) {
    const std::string name = code_name(EV_REL, code);
    if (name.empty()) continue;
    names.push_back(name + "+");
    names.push_back(name + "-");
  }
  return names;
}

/// SDL's name of a key to the kernel's, for a keyboard with the American layout.
std::string kernel_name(const std::string& key) {
  static constexpr auto kOthers =
      std::to_array<std::pair<std::string_view, std::string_view>>({{",", "COMMA"},
                                                                    {".", "DOT"},
                                                                    {"-", "MINUS"},
                                                                    {"=", "EQUAL"},
                                                                    {"/", "SLASH"},
                                                                    {"\\", "BACKSLASH"},
                                                                    {";", "SEMICOLON"},
                                                                    {"'", "APOSTROPHE"},
                                                                    {"`", "GRAVE"},
                                                                    {"[", "LEFTBRACE"},
                                                                    {"]", "RIGHTBRACE"},
                                                                    {"Escape", "ESC"},
                                                                    {"Return", "ENTER"}});
  const auto other = std::ranges::find(kOthers, key, [](const auto& pair) { return pair.first; });
  std::string name = "KEY_" + (other == kOthers.end() ? key : std::string(other->second));
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

}  // namespace

std::string unknown_key_remedy(const std::string& name) {
  if (parse_code(name)) return "";
  std::string nearest;
  for (const std::string& near : nearest_names(name, all_names(), 3))
    nearest += (nearest.empty() ? "" : ", ") + near;
  return "the nearest are " + nearest;
}

InputMap input_map(const EvdevDevice& device) {
  InputMap map;
  for (const auto& [name, button] : device.keys) {
    const std::optional<InputCode> code = parse_code(name);
    if (!code) {
      throw std::runtime_error("input device '" + device.name + "': no key or axis step is called '" + name +
                               "'; " + unknown_key_remedy(name));
    }
    map.emplace(*code, button);
  }
  return map;
}

InputMap input_map(std::span<const ButtonSpec> buttons) {
  InputMap map;
  for (const ButtonSpec& button : buttons) {
    if (button.key.empty()) continue;
    if (const auto code = parse_code(kernel_name(button.key))) map.emplace(*code, button.name);
  }
  return map;
}

std::string name_of(const InputCode& code) {
  const std::string name = code_name(code.type, code.code);
  return name + (code.direction == 0 ? "" : code.direction > 0 ? "+" : "-");
}

}  // namespace vitrine
