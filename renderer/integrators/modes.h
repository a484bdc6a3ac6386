// The sampling modes: each is a named choice of parts, one row of one table. The command line, the kiosk's
// button cycle, the HUD and the tests iterate this table; to add a mode, add a row in modes.cpp.
#pragma once

#include <span>
#include <string_view>

#include "integrators/sampling_parts.h"

namespace vitrine {

struct Mode {
  std::string_view key;
  std::string_view label;
  std::string_view section;  ///< of the lecture
  SamplingParts parts;
  std::string_view compare_with;  ///< the key of the mode that shows best what this one is about
};

/// Every mode, in the order of the button cycle.
std::span<const Mode> modes();
/// The mode of that key, or nullptr.
const Mode* find_mode(std::string_view key);

}  // namespace vitrine
