// The number system of machines without a floating-point unit, and of pictures that are the same bit for bit
// on every machine: all integers from the random number to the film.
#pragma once

#include <cstdint>
#include <optional>

#include "numeric/vec.h"

namespace vitrine {

struct FixedNumbers {
  using Unit = FixedUnit;
  using Length = FixedLength;
  using Area = Fixed<2 * kLengthBits, std::int64_t>;
  using Square = Fixed<2 * kUnitBits, std::int64_t>;
  using Density = Wide;
  using Weight = Wide;
  using Radiance = Wide;
  using TexCoord = Fixed<16>;
  using Inverse = FixedInverse;

  static constexpr Unit unit_from_bits(std::uint32_t bits) {
    return Unit::from_raw(static_cast<std::int32_t>(bits >> (32 - kUnitBits)));
  }
  template <int B>
  static constexpr std::uint32_t bits_of(Fixed<B> x) {
    return static_cast<std::uint32_t>(x.raw);
  }
  static constexpr Density density_from_count(std::uint32_t n) { return Wide::normalized(n, 0); }
  /// For counts up to 2^15: index and u make a number of 31 bits, the step has a resolution of 2^-45.
  static constexpr Unit pixel_coordinate(std::uint32_t index, Unit u, std::uint64_t step) {
    const std::uint64_t position =
        (std::uint64_t{index} << 16) | (static_cast<std::uint32_t>(u.raw) >> (kUnitBits - 16));
    return Unit::from_raw(
        static_cast<std::int32_t>((position * step + (std::uint64_t{1} << 31)) >> (45 + 16 - kUnitBits)));
  }
  static constexpr std::uint64_t pixel_step(std::uint32_t count) { return (std::uint64_t{1} << 45) / count; }

  static constexpr Inverse inverse(Unit d) { return Inverse(d); }

  struct Cell {
    int index;
    Unit fraction;
  };
  static constexpr Cell cell(TexCoord x) {
    const auto fraction = static_cast<std::uint32_t>(x.raw) & 0xffffU;
    return {x.raw >> 16, Unit::from_raw(static_cast<std::int32_t>(fraction << (kUnitBits - 16)))};
  }
  static constexpr Cell texel(Unit x, int size) {
    const std::int64_t position = std::int64_t{x.raw} * size - (std::int64_t{1} << (kUnitBits - 1));
    const std::int64_t index = position >> kUnitBits;
    return {static_cast<int>(index),
            Unit::from_raw(static_cast<std::int32_t>(position - (index << kUnitBits)))};
  }

  static constexpr Cell grid_cell(Unit x, int cells) {
    const std::int64_t position = std::int64_t{x.raw} * cells;
    const std::int64_t index = position >> kUnitBits;
    return {static_cast<int>(index),
            Unit::from_raw(static_cast<std::int32_t>(position - (index << kUnitBits)))};
  }

  static constexpr int quantize(Unit x, int steps) {
    return static_cast<int>(shift_right_rounded(std::int64_t{x.raw} * steps, kUnitBits));
  }

  static constexpr std::optional<std::int64_t> to_film(Radiance x, int bits, std::int64_t limit) {
    const int shift = -(x.exponent + bits);
    if (x.mantissa == 0 || shift > 33) return 0;
    if (shift < -30) return std::nullopt;
    const std::int64_t value = shift_right_rounded(std::int64_t{x.mantissa}, shift);
    if (value >= limit) return std::nullopt;
    return value;
  }
  static constexpr Radiance from_film(std::int64_t sum, std::uint32_t count, int bits) {
    return Wide::normalized(static_cast<std::uint64_t>(sum), -bits) / Wide::normalized(count, 0);
  }
  static constexpr int quarter_stop(Radiance x) {
    return 4 * (x.exponent + 31) + (x.mantissa >= 0x9837f052U) + (x.mantissa >= 0xb504f334U) +
           (x.mantissa >= 0xd744fccbU);
  }
};

}  // namespace vitrine
