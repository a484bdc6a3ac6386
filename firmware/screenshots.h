// Pictures that visitors ask to be saved. Visitors are many and a runtime folder lies in memory, so only the
// latest ones are kept.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "picture.h"

namespace vitrine {

inline constexpr std::size_t kKeptScreenshots = 50;

/// Writes FOLDER/vitrine-NAME.png, and removes the oldest vitrine-*.png beyond `kept`. Returns the file's
/// name. Throws std::runtime_error.
std::string save_screenshot(const std::filesystem::path& folder, const std::string& name,
                            const DevelopedPicture& picture, std::size_t kept = kKeptScreenshots);

}  // namespace vitrine
