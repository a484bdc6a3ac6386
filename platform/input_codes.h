// The kernel's names of keys and axes (KEY_NEXT, REL_X), and which of them a plain keyboard offers for the
// keys of the simulated box.
#pragma once

#include <compare>
#include <map>
#include <span>
#include <string>

#include "button_wiring.h"
#include "buttons.h"

namespace vitrine {

/// A key, or a direction of a relative axis: each step is a tap.
struct InputCode {
  unsigned type = 0;  ///< EV_KEY or EV_REL
  unsigned code = 0;
  int direction = 0;  ///< of an axis: 1 or -1
  auto operator<=>(const InputCode&) const = default;
};

using InputMap = std::map<InputCode, std::string>;  ///< to buttons

/// The names nearest to that of a key or an axis step which does not exist; empty when it does.
[[nodiscard]] std::string unknown_key_remedy(const std::string& name);

/// Of EvdevDevice::keys. Throws std::runtime_error, one line with the nearest names.
[[nodiscard]] InputMap input_map(const EvdevDevice& device);

/// The keys of ButtonSpec, which have SDL's names, where a keyboard has them.
[[nodiscard]] InputMap input_map(std::span<const ButtonSpec> buttons);

/// "KEY_NEXT", "REL_X+"
[[nodiscard]] std::string name_of(const InputCode& code);

}  // namespace vitrine
