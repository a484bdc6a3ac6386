#include "gpio_places.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "device_access.h"
#include "nearest_name.h"

namespace vitrine {
namespace {

constexpr std::size_t kFewNames = 5;

[[noreturn]] void fail(const GpioLine& line, const std::string& problem) {
  throw std::runtime_error("button '" + line.button + "': " + problem);
}

std::string list_of(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::optional<unsigned> offset_of(const std::string& text) {
  unsigned offset = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), offset);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(offset) : std::nullopt;
}

bool answers_to(const GpioChip& chip, const std::string& called) {
  if (chip.label == called || chip.name == called || chip.path == called) return true;
  std::error_code error;
  return called.starts_with('/') && std::filesystem::equivalent(chip.path, called, error);
}

/// "gpiochip0 (pinctrl-bcm2711)"
std::string title(const GpioChip& chip) { return chip.name + " (" + chip.label + ")"; }

std::vector<std::string> titles(std::span<const GpioChip* const> chips) {
  std::vector<std::string> all;
  for (const GpioChip* chip : chips) all.push_back(title(*chip));
  return all;
}

/// The chips in which to look.
std::vector<const GpioChip*> candidates(const GpioLine& line, const GpioInventory& inventory) {
  std::vector<const GpioChip*> all;
  for (const GpioChip& chip : inventory.chips) all.push_back(&chip);
  if (all.empty()) {
    fail(line, inventory.problems.empty()
                   ? "this machine shows no GPIO chip (/dev/gpiochip0); see that its driver is loaded"
                   : inventory.problems.front());
  }
  if (line.chip.empty()) return all;
  std::vector<const GpioChip*> called;
  std::ranges::copy_if(all, std::back_inserter(called),
                       [&](const GpioChip* chip) { return answers_to(*chip, line.chip); });
  if (called.empty()) {
    fail(line, "no GPIO chip is called '" + line.chip + "'; there are " + list_of(titles(all)) +
                   (inventory.problems.empty() ? "" : "; " + inventory.problems.front()));
  }
  return called;
}

}  // namespace

GpioInventory find_gpio_chips() {
  GpioInventory inventory;
  for (const std::filesystem::path& node : numbered_nodes("/dev", "gpiochip")) {
    try {
      inventory.chips.push_back(read_gpio_chip(node));
    } catch (const std::system_error& error) {
      inventory.problems.push_back(open_problem(node, error.code().value()));
    }
  }
  return inventory;
}

GpioPlace find_line(const GpioLine& line, const GpioInventory& inventory) {
  const std::vector<const GpioChip*> chips = candidates(line, inventory);

  std::vector<std::string> names;
  std::vector<std::pair<const GpioChip*, unsigned>> found;
  for (const GpioChip* chip : chips) {
    for (const GpioLineInfo& info : chip->lines) {
      if (!info.name.empty()) names.push_back(info.name);
      if (info.name == line.line) found.emplace_back(chip, info.offset);
    }
  }
  const std::optional<unsigned> offset = offset_of(line.line);
  if (found.empty() && offset) {  // a name goes before a number
    if (line.chip.empty())
      fail(line, "line " + line.line + " is a number; name its chip, too: " + list_of(titles(chips)));
    for (const GpioChip* chip : chips) {
      if (*offset < chip->lines.size()) found.emplace_back(chip, *offset);
    }
    if (found.empty()) {
      fail(line, title(*chips.front()) + " has no line " + line.line + "; it has 0 to " +
                     std::to_string(chips.front()->lines.size() - 1));
    }
  }
  if (found.empty()) {
    const std::string where = line.chip.empty() ? "any GPIO chip" : title(*chips.front());
    fail(line,
         "no line of " + where + " is named '" + line.line + "'; " +
             (names.empty() ? "none has a name: give chip and offset"
                            : "the nearest are " + list_of(nearest_names(line.line, names, kFewNames))));
  }
  if (found.size() > 1) {
    std::vector<std::string> places;
    for (const auto& [chip, n] : found) places.push_back(chip->name + " line " + std::to_string(n));
    fail(line, "'" + line.line + "' is ambiguous: " + list_of(places) + "; give chip and offset");
  }
  return {found.front().first->path, found.front().second};
}

}  // namespace vitrine
