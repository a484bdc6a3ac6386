// The variance map: where a picture is still noisy. Each pixel in the colour of its relative standard error
// sqrt(V) / m (see error_estimate.h), eight stops on a logarithmic scale from black to white.
#pragma once

#include <array>
#include <cstdint>

#include "film/film.h"

namespace vitrine {

/// Red, green, blue of a relative standard error: black at 1/256 (0.4 %) and below, then blue, purple, red,
/// orange, yellow, and white at 1 (100 %) and above. Grey where nothing is known: no light was found yet.
std::array<std::uint8_t, 3> variance_colour(const Film::Pixel& pixel);

/// Writes the pixels of `tile` into `rgb`, as Renderer::develop() does.
void develop_variance_map(const Film& film, const Tile& tile, std::uint8_t* rgb);

}  // namespace vitrine
