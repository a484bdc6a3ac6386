#include "command_probe.h"

#include <algorithm>
#include <iostream>
#include <sstream>
#include <string_view>

#include "actions.h"
#include "exit_status.h"

namespace vitrine {
namespace {

constexpr std::size_t kFewModes = 6;
constexpr std::size_t kFewCodes = 12;

std::string list_of(const std::vector<std::string>& words, std::size_t most) {
  std::string list;
  for (std::size_t i = 0; i < std::min(words.size(), most); ++i) list += (i == 0 ? "" : ", ") + words[i];
  if (words.size() > most) list += ", ... (" + std::to_string(words.size()) + ")";
  return list;
}

std::string_view plugged_text(Plugged plugged) {
  switch (plugged) {
    case Plugged::kNo:
      return "nothing plugged in";
    case Plugged::kUnknown:
      return "cannot tell whether a screen is there";
    case Plugged::kYes:
      break;
  }
  return "a screen";
}

/// The keys of a [[gpio]] table that say which line is meant, by names where they are unique.
std::string line_keys(const GpioInventory& inventory, const GpioChip& chip, const GpioLineInfo& line) {
  const auto same = [&](const GpioChip& other) {
    return std::ranges::count(other.lines, line.name, &GpioLineInfo::name);
  };
  std::ptrdiff_t named = 0;
  for (const GpioChip& other : inventory.chips) named += same(other);
  if (!line.name.empty() && named == 1) return "line = \"" + line.name + "\"";
  const bool labelled =
      !chip.label.empty() && std::ranges::count(inventory.chips, chip.label, &GpioChip::label) == 1;
  const std::string name = labelled ? chip.label : chip.name;
  return "chip = \"" + name + "\", line = " + std::to_string(line.offset);
}

std::string line_state(const GpioLineInfo& line) {
  if (!line.used) return line.output ? "free (output)" : "free";
  return "used by " + (line.consumer.empty() ? "the kernel" : line.consumer);
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 1, width), ' ');
  return text;
}

void write_screens(std::ostream& out, const ScreenInventory& screens) {
  out << "Screens\n";
  for (const CardInfo& card : screens.cards) {
    out << "  " << card.path << "  card = \"" << card.driver << "\"  " << card.bus << "  "
        << list_of(card.formats, kFewModes) << '\n';
    if (!card.problem.empty()) out << "    " << card.problem << '\n';
    for (const ConnectorInfo& connector : card.connectors) {
      std::vector<std::string> modes;
      for (const ScreenMode& mode : connector.modes)
        modes.push_back(mode_text(mode) + (mode.preferred ? " (preferred)" : ""));
      out << "    connector = \"" << connector.name << "\"  " << plugged_text(connector.plugged)
          << (modes.empty() ? "" : ": " + list_of(modes, kFewModes)) << '\n';
    }
  }
  for (const FramebufferInfo& device : screens.framebuffers) {
    out << "  " << device.path << "  device = \"" << (device.id.empty() ? device.path : device.id) << "\"  ";
    if (device.problem.empty())
      out << device.width << 'x' << device.height << ", " << layout_text(device.layout);
    out << '\n';
    if (!device.problem.empty()) out << "    " << device.problem << '\n';
  }
  if (screens.cards.empty() && screens.framebuffers.empty())
    out << "  none: neither a card in /dev/dri nor a framebuffer /dev/fb0\n";
}

void write_pins(std::ostream& out, const std::optional<GpioInventory>& gpio) {
  out << "\nPins\n";
  if (!gpio) {
    out << "  not looked for: this build has no gpio\n";
    return;
  }
  const GpioChip* free_chip = nullptr;
  const GpioLineInfo* free_line = nullptr;
  for (const GpioChip& chip : gpio->chips) {
    out << "  " << chip.name << " (" << chip.label << "), " << chip.lines.size() << " lines\n";
    for (const GpioLineInfo& line : chip.lines) {
      out << "    " << padded(std::to_string(line.offset), 4)
          << padded(line.name.empty() ? "-" : line.name, 20) << padded(line_state(line), 24)
          << (line.used ? "" : line_keys(*gpio, chip, line)) << '\n';
      // A line with a name is likelier to have a pin.
      const bool better = free_line == nullptr || (free_line->name.empty() && !line.name.empty());
      if (!line.used && better) {
        free_chip = &chip;
        free_line = &line;
      }
    }
  }
  for (const std::string& problem : gpio->problems) out << "  " << problem << '\n';
  if (gpio->chips.empty() && gpio->problems.empty()) out << "  none: there is no /dev/gpiochip0\n";
  if (free_line == nullptr) return;
  std::string keys = line_keys(*gpio, *free_chip, *free_line);
  if (const std::size_t comma = keys.find(", line"); comma != std::string::npos)
    keys.replace(comma, 2, "\n    ");
  out << "  For a button between a line and ground, write into the configuration:\n"
         "    [[gpio]]\n"
         "    button = \"scene\"\n"
         "    "
      << keys << "\n    active_low = true\n    bias = \"pull-up\"\n";
}

void write_devices(std::ostream& out, const std::optional<InputInventory>& input) {
  out << "\nInput devices\n";
  if (!input) {
    out << "  not looked for: this build has no evdev\n";
    return;
  }
  for (const InputInventory::Found& found : input->devices) {
    out << "  " << found.device.node.string() << "  name = \"" << found.device.name << "\"\n    "
        << (found.unused.empty() ? "used" : "not used unless named: " + found.unused) << "\n";
    for (const std::string& link : found.links) out << "    " << link << '\n';
    if (!found.codes.empty()) out << "    " << list_of(found.codes, kFewCodes) << '\n';
  }
  for (const std::string& problem : input->problems) out << "  " << problem << '\n';
  if (input->devices.empty() && input->problems.empty()) out << "  none: there is no /dev/input/event0\n";
}

Json screens_json(const ScreenInventory& screens) {
  Json list = Json::array();
  for (const CardInfo& card : screens.cards) {
    Json connectors = Json::array();
    for (const ConnectorInfo& connector : card.connectors) {
      Json modes = Json::array();
      for (const ScreenMode& mode : connector.modes) {
        modes.push_back({{"mode", mode_text(mode)},
                         {"width", mode.width},
                         {"height", mode.height},
                         {"refresh_hz", mode.refresh_hz},
                         {"preferred", mode.preferred}});
      }
      const bool unknown = connector.plugged == Plugged::kUnknown;
      connectors.push_back({{"name", connector.name},
                            {"plugged", unknown ? Json(nullptr) : Json(connector.plugged == Plugged::kYes)},
                            {"modes", modes}});
    }
    list.push_back({{"path", card.path},
                    {"driver", card.driver},
                    {"bus", card.bus},
                    {"formats", card.formats},
                    {"problem", card.problem},
                    {"connectors", connectors}});
  }
  return list;
}

Json framebuffers_json(const ScreenInventory& screens) {
  Json list = Json::array();
  for (const FramebufferInfo& device : screens.framebuffers) {
    list.push_back({{"path", device.path},
                    {"id", device.id},
                    {"width", device.width},
                    {"height", device.height},
                    {"stride_bytes", device.stride_bytes},
                    {"layout", layout_text(device.layout)},
                    {"problem", device.problem}});
  }
  return list;
}

Json chips_json(const GpioInventory& gpio) {
  Json list = Json::array();
  for (const GpioChip& chip : gpio.chips) {
    Json lines = Json::array();
    for (const GpioLineInfo& line : chip.lines) {
      lines.push_back({{"offset", line.offset},
                       {"name", line.name},
                       {"free", !line.used},
                       {"consumer", line.consumer},
                       {"direction", line.output ? "output" : "input"},
                       {"config", line_keys(gpio, chip, line)}});
    }
    list.push_back(
        {{"path", chip.path.string()}, {"name", chip.name}, {"label", chip.label}, {"lines", lines}});
  }
  return list;
}

Json devices_json(const InputInventory& input) {
  Json list = Json::array();
  for (const InputInventory::Found& found : input.devices) {
    list.push_back({{"path", found.device.node.string()},
                    {"name", found.device.name},
                    {"links", found.links},
                    {"used", found.unused.empty()},
                    {"why_not", found.unused},
                    {"codes", found.codes}});
  }
  return list;
}

}  // namespace

std::string probe_text(const Inventory& inventory) {
  std::ostringstream out;
  write_screens(out, inventory.screens);
  write_pins(out, inventory.buttons.gpio);
  write_devices(out, inventory.buttons.input);
  return out.str();
}

Json probe_json(const Inventory& inventory) {
  Json problems = Json::array();
  Json chips;  // null: not looked for
  Json devices;
  if (const auto& gpio = inventory.buttons.gpio) {
    chips = chips_json(*gpio);
    for (const std::string& problem : gpio->problems) problems.push_back(problem);
  }
  if (const auto& input = inventory.buttons.input) {
    devices = devices_json(*input);
    for (const std::string& problem : input->problems) problems.push_back(problem);
  }
  return {{"cards", screens_json(inventory.screens)},
          {"framebuffers", framebuffers_json(inventory.screens)},
          {"gpio_chips", chips},
          {"input_devices", devices},
          {"problems", problems}};
}

int execute(const ProbeRequest& request) {
  const Inventory inventory{list_screens(), list_buttons(button_specs())};
  if (request.json) {
    print_json(probe_json(inventory));
  } else {
    std::cout << probe_text(inventory);
  }
  return kDone;
}

}  // namespace vitrine
