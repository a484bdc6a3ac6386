#include "frame/error_estimate.h"

#include "numeric/color.h"

namespace vitrine {

std::optional<PixelError> pixel_error(const Film::Pixel& pixel) {
  if (pixel.samples < 2) return std::nullopt;
  const auto wide = [](std::int64_t sum) {
    return Wide::normalized(static_cast<std::uint64_t>(sum), -kFilmBits);
  };
  const Wide n = Wide::normalized(pixel.samples, 0);
  const Wide mean =
      luminance<FixedUnit>(Vec3<Wide>(wide(pixel.sum.x), wide(pixel.sum.y), wide(pixel.sum.z))) / n;
  const Wide spread = excess(pixel.luminance_squares / n, mean * mean);
  return PixelError{mean, spread / Wide::normalized(pixel.samples - 1, 0)};
}

ErrorSums sum_errors(const Film& film, const Tile& tile) {
  ErrorSums sums;
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      if (const std::optional<PixelError> error = pixel_error(film.at(x, y)))
        sums += {error->mean, sqrt(error->variance)};
    }
  }
  return sums;
}

std::optional<Wide> relative_error(const ErrorSums& sums) {
  if (sums.means == Wide::zero()) return std::nullopt;
  return sums.deviations / sums.means;
}

}  // namespace vitrine
