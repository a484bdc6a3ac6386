// How a box is set up: from its config file, and from the command line, which has the last word.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "environment_choice.h"
#include "frame/renderer.h"
#include "hardware_config.h"
#include "manners_config.h"
#include "picture_size.h"
#include "supervision_config.h"

namespace vitrine {

/// Whatever is not given is left to the program.
struct BoxConfig {
  std::optional<std::string> display;  ///< a key, or "auto"; goes before hardware.display.backend
  std::optional<std::string> buttons;  ///< comma-separated keys, or "auto"
  std::optional<std::filesystem::path> playlist;
  std::optional<std::filesystem::path> lecture;
  std::optional<PictureSize> size;
  std::optional<const Mode*> mode;
  std::optional<Numbers> numbers;
  std::optional<int> threads;
  std::optional<std::uint32_t> max_spp;              ///< samples a pixel with which tracing rests
  std::optional<EnvironmentChoice> environment;      ///< of scenes that bring no light at all
  std::optional<std::filesystem::path> screenshots;  ///< a folder
  std::optional<bool> pixel_shift;                   ///< whether the labels walk, to spare the panel
  HardwareConfig hardware;                           ///< with that of the board file
  std::optional<IdleSettings> idle;
  std::vector<DimSpan> dim;
  std::optional<GovernorSettings> governor;
  std::optional<HealthSettings> health;

  /// The display's key: the command line's, the file's, or "auto".
  [[nodiscard]] std::string display_key() const {
    return display ? *display : hardware.display.backend.value_or("auto");
  }
};

/// Reads a TOML file with the keys that firmware/kiosk.toml explains, and the board file that it names.
/// Files are relative to it. Throws InputError.
BoxConfig read_box_config(const std::filesystem::path& path);

/// `over`, from the command line, where it says something, else `base`, from a file.
BoxConfig overlay(const BoxConfig& base, const BoxConfig& over);

}  // namespace vitrine
