// `vitrine probe`: what is on this machine for a person who wires a board: screens and their modes, pins that
// are free and what to write into the configuration for them, input devices and whether they are used.
#pragma once

#include <string>

#include "backends.h"
#include "json_output.h"

namespace vitrine {

struct ProbeRequest {
  bool json = false;
};

struct Inventory {
  ScreenInventory screens;
  ButtonInventory buttons;
};

[[nodiscard]] std::string probe_text(const Inventory& inventory);
[[nodiscard]] Json probe_json(const Inventory& inventory);

int execute(const ProbeRequest& request);

}  // namespace vitrine
