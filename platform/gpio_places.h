// Where the lines of a configuration are on this machine: the chips there are, and a line's name or a chip's
// label turned into a chip and an offset.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "button_wiring.h"
#include "gpio_lines.h"

namespace vitrine {

struct GpioInventory {
  std::vector<GpioChip> chips;
  std::vector<std::string> problems;  ///< "PATH: REASON; REMEDY" of chips that could not be read
};

[[nodiscard]] GpioInventory find_gpio_chips();

struct GpioPlace {
  std::filesystem::path chip;
  unsigned offset = 0;
};

/// Throws std::runtime_error, one line with the names that come near.
[[nodiscard]] GpioPlace find_line(const GpioLine& line, const GpioInventory& inventory);

}  // namespace vitrine
