// The number system of machines with a floating-point unit: every quantity is a float. The names of the
// quantities are those of FixedNumbers, where they differ; the rules of fixed.h vanish here, so the fixed
// instantiation must always be built too: only that one catches a mistake of units.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "numeric/vec.h"

namespace vitrine {

struct FloatNumbers {
  using Unit = float;      ///< cosines, unit vectors, random numbers, reflectances
  using Length = float;    ///< positions and distances, in baked units
  using Area = float;      ///< Length * Length
  using Square = float;    ///< Unit * Unit where small squares matter
  using Density = float;   ///< 1/sr, 1/area, BSDF values, MIS ratios
  using Weight = float;    ///< throughput
  using Radiance = float;  ///< in the film's units
  using TexCoord = float;  ///< texture coordinates before wrapping
  using Inverse = float;   ///< 1 / direction component

  /// Uniform in [0, 1) from 32 random bits.
  static constexpr Unit unit_from_bits(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24F;
  }
  /// The number's representation, for hashing.
  static constexpr std::uint32_t bits_of(float x) { return std::bit_cast<std::uint32_t>(x); }
  static constexpr Density density_from_count(std::uint32_t n) { return static_cast<float>(n); }
  /// (index + u) / count, where `inverse_count` is pixel_step(count).
  static constexpr Unit pixel_coordinate(std::uint32_t index, Unit u, float step) {
    return (static_cast<float>(index) + u) * step;
  }
  static constexpr float pixel_step(std::uint32_t count) { return 1.0F / static_cast<float>(count); }

  static Inverse inverse(Unit d) {  // finite, so that a slab never sees 0 * infinity; -0 is not negative
    constexpr float kTiny = 1e-18F;
    return 1.0F / (std::fabs(d) < kTiny ? (d < 0 ? -kTiny : kTiny) : d);
  }

  struct Cell {
    int index;
    Unit fraction;  ///< in [0, 1); just below 0 it rounds to 1
  };
  /// The integer below `x`, and the rest.
  static Cell cell(TexCoord x) {
    const float floor = std::floor(x);
    constexpr float kLimit = 1e9F;
    if (!(std::fabs(floor) < kLimit)) return {0, 0.0F};
    return {static_cast<int>(floor), x - floor};
  }
  /// Where x in [0, 1] lies between the centres of `size` texels.
  static Cell texel(Unit x, int size) { return cell(x * static_cast<float>(size) - 0.5F); }

  /// Which of `cells` equal parts of [0, 1] holds x, and where in it; cell `cells` for 1.
  static Cell grid_cell(Unit x, int cells) { return cell(x * static_cast<float>(cells)); }

  /// x in [0, 1] as one of steps + 1 integers, rounded to nearest.
  static constexpr int quantize(Unit x, int steps) {
    return static_cast<int>(x * static_cast<float>(steps) + 0.5F);
  }

  /// Radiance as the film stores it (2^-bits units), or nothing if it is not finite or beyond `limit`.
  static std::optional<std::int64_t> to_film(Radiance x, int bits, std::int64_t limit) {
    const double scaled = std::ldexp(static_cast<double>(x), bits);
    if (!(scaled < static_cast<double>(limit)) || scaled < 0)
      return std::nullopt;  // NaN fails the first test
    return static_cast<std::int64_t>(scaled + 0.5);
  }
  /// The mean of `count` > 0 film values that sum to `sum` >= 0.
  static Radiance from_film(std::int64_t sum, std::uint32_t count, int bits) {
    return static_cast<float>(std::ldexp(static_cast<double>(sum) / count, -bits));
  }
  /// floor(4 log2 x), for x > 0: which quarter stop a radiance lies in.
  static int quarter_stop(Radiance x) {
    int exponent = 0;
    const float mantissa = std::frexp(x, &exponent) * 2.0F;  // in [1, 2)
    return 4 * (exponent - 1) + (mantissa >= 0x1.306fe0a31b715p+0F) + (mantissa >= 0x1.6a09e667f3bcdp+0F) +
           (mantissa >= 0x1.ae89f995ad3adp+0F);
  }
};

}  // namespace vitrine
