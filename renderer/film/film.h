// The film: what each pixel has collected. Sums are 64-bit integers in both number systems, so they are
// exact, do not depend on the order of the samples, and need no floating point.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "numeric/color.h"
#include "numeric/fixed.h"
#include "numeric/wide.h"

namespace vitrine {

/// Binary digits of a film value behind the point: 1.0, about the scene's brightest light, is 2^36.
inline constexpr int kFilmBits = 36;

/// The most that one sample may bring, a million times that light; more counts as non-finite.
inline constexpr std::int64_t kFilmSampleLimit = std::int64_t{1} << (kFilmBits + 20);

using FilmValue = glm::vec<3, std::int64_t, glm::defaultp>;

/// A rectangle of pixels: [x0, x1) x [y0, y1), y downwards.
struct Tile {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  [[nodiscard]] int width() const { return x1 - x0; }
  [[nodiscard]] int height() const { return y1 - y0; }
};

/// Samples [first, first + count) of every pixel.
struct SampleRange {
  std::uint32_t first = 0;
  std::uint32_t count = 1;
};

/// Width x height pixels of linear Rec.709 radiance. Any number of threads may add to different pixels at
/// once.
class Film {
 public:
  struct Pixel {
    FilmValue sum{0};                       ///< in units of 2^-kFilmBits * 2^exponent nits
    Wide luminance_squares = Wide::zero();  ///< the sum of each sample's, in (2^exponent nits)^2
    std::uint32_t samples = 0;              ///< that were added; dropped ones do not count
  };

  /// `exponent`: film value 1.0 stands for 2^exponent nits; the renderer says which suits its scene.
  Film(int width, int height, int exponent)
      : width_(width),
        height_(height),
        exponent_(exponent),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int exponent() const { return exponent_; }
  [[nodiscard]] const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }

  /// `sample`: each component in [0, kFilmSampleLimit).
  void add(int x, int y, const FilmValue& sample) {
    Pixel& pixel = pixels_[index(x, y)];
    for (int c = 0; c < 3; ++c) pixel.sum[c] = std::min(pixel.sum[c], kSumLimit) + sample[c];
    const Wide brightness = luminance(sample);
    pixel.luminance_squares += brightness * brightness;
    ++pixel.samples;
  }

  /// Mean radiance of a pixel in nits, (0,0,0) without samples. For files and tests; the live picture never
  /// leaves the number system.
  [[nodiscard]] glm::dvec3 mean_nits(int x, int y) const;

 private:
  static Wide luminance(const FilmValue& value) {
    const auto wide = [](std::int64_t x) {
      return Wide::normalized(static_cast<std::uint64_t>(x), -kFilmBits);
    };
    return vitrine::luminance<FixedUnit>(Vec3<Wide>(wide(value.x), wide(value.y), wide(value.z)));
  }

  static constexpr std::int64_t kSumLimit = INT64_MAX - kFilmSampleLimit;

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_;
  int height_;
  int exponent_;
  std::vector<Pixel> pixels_;
};

}  // namespace vitrine
