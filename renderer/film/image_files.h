// Pictures on disk: PFM for radiance, PNG for what a screen shows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "film/film.h"

namespace vitrine {

/// 32-bit linear Rec.709 radiance in nits, little endian, rows bottom to top as the format says.
/// Throws std::runtime_error with the path and the system's reason.
void write_pfm(const std::filesystem::path& path, const Film& film);
/// The same of two films of one size: from `column` on that of `right`.
void write_pfm(const std::filesystem::path& path, const Film& left, const Film& right, int column);

/// 8-bit sRGB, 3 bytes a pixel, rows top to bottom. Throws std::runtime_error with the path and the system's
/// reason.
void write_png(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace vitrine
