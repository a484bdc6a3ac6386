// Pictures where there is neither desktop nor console: every scene of the playlist in turn, into a file each.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>

#include "exhibit.h"

namespace vitrine {

/// Samples a pixel of a tour's pictures: a first impression, in seconds even on a small board.
inline constexpr std::uint32_t kTourSamples = 16;

/// Writes FOLDER/NAME.png for each scene until `stop`, and calls `written` with its path; a scene that cannot
/// be shown is told on stderr. Returns whether all could. Throws std::runtime_error when a file cannot be
/// written.
bool take_tour(const ExhibitSettings& settings, const std::filesystem::path& folder, Workers& workers,
               const LoadScene& load, const std::atomic<bool>& stop,
               const std::function<void(const std::filesystem::path&)>& written);

}  // namespace vitrine
