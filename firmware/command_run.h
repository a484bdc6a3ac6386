// `vitrine run`: the box itself. Scenes on a display, changed by buttons.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "box_config.h"
#include "comparison.h"
#include "technique.h"

namespace vitrine {

struct RunRequest {
  std::vector<std::string> scenes;  ///< files and names; empty: the playlist
  BoxConfig box;
  std::vector<ParameterChange> changes;  ///< to every mode that has such parameters
  std::vector<Technique> compare;        ///< two to begin with side by side, or none
  Fairness fairness = Fairness::kEqualSamples;
  std::optional<std::filesystem::path> config;  ///< for what `box` leaves open
  std::uint64_t seed = 0;
  std::optional<std::uint64_t> frames;
  std::optional<std::filesystem::path> script;
  std::optional<std::filesystem::path> out;             ///< a PNG file; a folder for a tour of pictures
  std::optional<std::filesystem::path> runtime_folder;  ///< instead of the one that systemd names
  bool check_config = false;                            ///< read everything, say what it comes to, and end
  bool safe = false;  ///< the built-in scene, and a card that says why the box failed
  bool json = false;
};

int execute(const RunRequest& request);

}  // namespace vitrine
