// What the buttons of the box do: one table from button to action, with the caption and the key that the
// simulated box shows. To add a button, add a row in actions.cpp and say in kiosk.cpp what it does; each
// parameter of the modes has a button by itself.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "buttons.h"
#include "integrators/parameters.h"

namespace vitrine {

enum class Action : std::uint8_t {
  kNextScene,
  kPreviousScene,
  kNextMode,
  kPreviousMode,
  kParameter,
  kLecture,
  kCompare,
  kFairness,
  kSplitLeft,
  kSplitRight,
  kView,
  kNumbers,
  kPause,
  kBrighter,
  kDarker,
  kAutoExposure,
  kHud,
  kScreenshot,
  kQuit,
};

struct ActionButton {
  Action action;
  std::string_view button;   ///< ButtonSpec::name
  std::string_view caption;  ///< empty: not on the screen; a second key of a button above
  std::string_view key;
  std::string_view meaning;  ///< for the help
  /// Whether it leads away from a stop of the lecture, not only to another look at it.
  bool leaves_lecture = false;
  const Parameter* parameter = nullptr;  ///< of kParameter
};

/// Every button, in the order of the simulated box.
std::span<const ActionButton> action_buttons();

/// The table as backends want it.
std::vector<ButtonSpec> button_specs();

/// The names of all actions, each once.
std::vector<std::string> action_names();

/// The button of that name, or nullptr.
const ActionButton* find_action(std::string_view button);

}  // namespace vitrine
