#include "actions.h"

#include <algorithm>
#include <array>

namespace vitrine {
namespace {

constexpr auto kActionButtons = std::to_array<ActionButton>({
    {Action::kPreviousScene, "scene-back", "< Scene", "Left", "the scene before"},
    {Action::kNextScene, "scene", "Scene >", "Right", "the next scene"},
    {Action::kPreviousMode, "mode-back", "< Mode", "B", "the sampling mode before"},
    {Action::kNextMode, "mode", "Mode >", "M", "the next sampling mode"},
    {Action::kNumbers, "numbers", "Numbers", "N", "float or fixed-point numbers"},
    {Action::kPause, "pause", "Pause", "Space", "stop and go on"},
    {Action::kDarker, "exposure-down", "EV -", "Down", "half a stop darker"},
    {Action::kBrighter, "exposure-up", "EV +", "Up", "half a stop brighter"},
    {Action::kAutoExposure, "exposure-auto", "EV auto", "A", "automatic exposure"},
    {Action::kHud, "hud", "HUD", "H", "show or hide the labels"},
    {Action::kScreenshot, "screenshot", "Save", "C", "save what is shown as a PNG in the current folder"},
    {Action::kQuit, "quit", "Quit", "Escape", "end the program"},
    {Action::kQuit, "quit", "", "Q", "end the program"},
});

}  // namespace

std::span<const ActionButton> action_buttons() { return kActionButtons; }

std::vector<ButtonSpec> button_specs() {
  std::vector<ButtonSpec> specs;
  for (const ActionButton& row : kActionButtons) {
    specs.push_back({std::string(row.button), std::string(row.caption), std::string(row.key)});
  }
  return specs;
}

std::optional<Action> find_action(std::string_view button) {
  const auto found = std::ranges::find(kActionButtons, button, &ActionButton::button);
  if (found == kActionButtons.end()) return std::nullopt;
  return found->action;
}

}  // namespace vitrine
