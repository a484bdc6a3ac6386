#include "frame/variance_map.h"

#include <algorithm>
#include <cstddef>

#include "frame/error_estimate.h"

namespace vitrine {
namespace {

using Colour = std::array<std::uint8_t, 3>;

constexpr Colour kUnknown{48, 48, 48};

/// A step each two stops of the squared error, sixteen codes a stop: brighter and brighter.
constexpr auto kLandmarks = std::to_array<Colour>({{0, 0, 0},
                                                   {16, 12, 84},
                                                   {72, 12, 130},
                                                   {136, 22, 120},
                                                   {196, 44, 82},
                                                   {236, 98, 30},
                                                   {250, 164, 26},
                                                   {250, 226, 100},
                                                   {255, 255, 255}});
constexpr int kCodesApart = 32;
constexpr int kCodes = (static_cast<int>(kLandmarks.size()) - 1) * kCodesApart;

constexpr Colour colour_of(int code) {
  const auto below = static_cast<std::size_t>(std::clamp(code, 0, kCodes - 1) / kCodesApart);
  const int part = std::clamp(code, 0, kCodes) - static_cast<int>(below) * kCodesApart;
  Colour colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    colour[c] = static_cast<std::uint8_t>(
        (kLandmarks[below][c] * (kCodesApart - part) + kLandmarks[below + 1][c] * part) / kCodesApart);
  }
  return colour;
}

/// 16 log2 x, the logarithm between powers of two taken for a straight line.
constexpr int sixteenths_of_log2(Wide x) {
  return 16 * (x.exponent + 31) + static_cast<int>((x.mantissa >> 27) & 15U);
}

}  // namespace

Colour variance_colour(const Film::Pixel& pixel) {
  const std::optional<PixelError> error = pixel_error(pixel);
  if (!error || error->mean == Wide::zero()) return kUnknown;
  if (error->variance == Wide::zero()) return kLandmarks.front();
  return colour_of(kCodes + sixteenths_of_log2(error->variance / (error->mean * error->mean)));
}

void develop_variance_map(const Film& film, const Tile& tile, std::uint8_t* rgb) {
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const Colour colour = variance_colour(film.at(x, y));
      std::ranges::copy(colour, rgb + 3 * (static_cast<std::ptrdiff_t>(y) * film.width() + x));
    }
  }
}

}  // namespace vitrine
