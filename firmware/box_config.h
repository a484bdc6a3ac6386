// How a box is set up: from its config file, and from the command line, which has the last word.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "environment_choice.h"
#include "frame/renderer.h"
#include "picture_size.h"

namespace vitrine {

/// Whatever is not given is left to the program.
struct BoxConfig {
  std::optional<std::string> display;  ///< a key, or "auto"
  std::optional<std::string> buttons;  ///< comma-separated keys, or "auto"
  std::optional<std::filesystem::path> playlist;
  std::optional<std::filesystem::path> lecture;
  std::optional<PictureSize> size;
  std::optional<const Mode*> mode;
  std::optional<Numbers> numbers;
  std::optional<int> threads;
  std::optional<EnvironmentChoice> environment;  ///< of scenes that bring no light at all
};

/// Reads a TOML file with the keys `display`, `buttons`, `playlist`, `lecture` (relative to the file),
/// `size`, `mode`, `numbers`, `threads` and those of an environment. Throws InputError.
BoxConfig read_box_config(const std::filesystem::path& path);

/// `over` where it says something, else `base`.
BoxConfig overlay(const BoxConfig& base, const BoxConfig& over);

}  // namespace vitrine
