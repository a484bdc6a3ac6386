#include "actions.h"

#include <algorithm>
#include <array>

namespace vitrine {
namespace {

constexpr auto kActionButtons = std::to_array<ActionButton>({
    {Action::kPreviousScene, "scene-back", "< Scene", "Left", "the scene before", true},
    {Action::kNextScene, "scene", "Scene >", "Right", "the next scene", true},
    {Action::kPreviousMode, "mode-back", "< Mode", "B", "the sampling mode before", true},
    {Action::kNextMode, "mode", "Mode >", "M",
     "the next sampling mode; in a comparison, like the parameters, that of the right side", true},
    {Action::kLecture, "lecture", "Lecture", "L", "the next stop of the lecture"},
    {Action::kCompare, "compare", "Compare", "S", "side by side with another mode, or the left one alone",
     true},
    {Action::kFairness, "equal", "Equal", "E", "compare at equal samples or at equal time"},
    {Action::kSplitLeft, "split-left", "< Split", ",", "less of the left side"},
    {Action::kSplitRight, "split-right", "Split >", ".", "more of the left side"},
    {Action::kView, "view", "View", "V", "the picture, or a map of its variance"},
    {Action::kNumbers, "numbers", "Numbers", "N", "float or fixed-point numbers"},
    {Action::kPause, "pause", "Pause", "Space", "stop and go on"},
    {Action::kDarker, "exposure-down", "EV -", "Down", "half a stop darker"},
    {Action::kBrighter, "exposure-up", "EV +", "Up", "half a stop brighter"},
    {Action::kAutoExposure, "exposure-auto", "EV auto", "A", "automatic exposure"},
    {Action::kHud, "hud", "HUD", "H", "show or hide the labels"},
    {Action::kScreenshot, "screenshot", "Save", "C", "save what is shown as a PNG"},
    {Action::kQuit, "quit", "Quit", "Escape", "end the program"},
    {Action::kQuit, "quit", "", "Q", "end the program"},
});

/// The parameters stand together behind the modes.
std::vector<ActionButton> all_buttons() {
  std::vector<ActionButton> buttons(kActionButtons.begin(), kActionButtons.end());
  auto place = std::ranges::find(buttons, Action::kNextMode, &ActionButton::action) + 1;
  for (const Parameter& parameter : parameters()) {
    place = buttons.insert(place, {Action::kParameter, parameter.name, parameter.label, parameter.key,
                                   parameter.meaning, true, &parameter}) +
            1;
  }
  return buttons;
}

}  // namespace

std::span<const ActionButton> action_buttons() {
  static const std::vector<ActionButton> buttons = all_buttons();
  return buttons;
}

std::vector<ButtonSpec> button_specs() {
  std::vector<ButtonSpec> specs;
  for (const ActionButton& row : action_buttons()) {
    specs.push_back({std::string(row.button), std::string(row.caption), std::string(row.key)});
  }
  return specs;
}

std::vector<std::string> action_names() {
  std::vector<std::string> names;
  for (const ActionButton& row : action_buttons()) {
    if (!row.caption.empty()) names.emplace_back(row.button);
  }
  return names;
}

const ActionButton* find_action(std::string_view button) {
  const auto found = std::ranges::find(action_buttons(), button, &ActionButton::button);
  return found == action_buttons().end() ? nullptr : &*found;
}

}  // namespace vitrine
