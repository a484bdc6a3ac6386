// Fixed<B>: a strong fixed-point number with B binary digits behind the point. Nothing converts silently: a
// product has the type that its meaning asks for, everything else is an explicit constructor.
//
//   Unit  Q2.29  +-4    cosines, unit vectors, uv, random numbers, reflectances: the dimensionless scalar
//   Length Q3.28 +-8    positions and distances; scenes are baked into about +-1
//   Area, Square        exact 64-bit products of two Lengths, of two Units
//
// Unit times anything keeps the other's type; Length times Length is an exact Area. All narrowing rounds to
// nearest, since truncation would bias every sum that follows.
#pragma once

#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "numeric/integer_math.h"

namespace vitrine {

template <int B, class Rep = std::int32_t>
struct Fixed {
  Rep raw;

  Fixed() = default;
  /// Constants only, so no floating point reaches run time; out of range does not compile.
  consteval explicit Fixed(double value) : raw(0) {
    const double scaled = value * static_cast<double>(Rep{1} << B) + (value < 0 ? -0.5 : 0.5);
    if (!(scaled < 9.2e18 && scaled > -9.2e18) ||
        static_cast<std::int64_t>(static_cast<Rep>(static_cast<std::int64_t>(scaled))) !=
            static_cast<std::int64_t>(scaled)) {
      throw "constant out of the range of this quantity";
    }
    raw = static_cast<Rep>(scaled);
  }
  /// Small integer constants read as themselves: 1 - x, x > 0.
  template <std::same_as<int> I>
  consteval Fixed(I value) : Fixed(static_cast<double>(value)) {}  // NOLINT: implicit on purpose
  /// From another format; digits that do not fit behind the point are rounded.
  template <int C, class S>
  requires(C != B || !std::same_as<S, Rep>) constexpr explicit Fixed(Fixed<C, S> other) : raw(0) {
    if constexpr (B >= C) {
      raw = static_cast<Rep>(static_cast<Rep>(other.raw) << (B - C));
    } else {
      raw = static_cast<Rep>((other.raw + (S{1} << (C - B - 1))) >> (C - B));
    }
  }
  static constexpr Fixed from_raw(Rep raw) {
    Fixed x{};
    x.raw = raw;
    return x;
  }

  constexpr Fixed operator-() const { return from_raw(static_cast<Rep>(-raw)); }
  constexpr Fixed& operator+=(Fixed other) { return *this = *this + other; }
  constexpr Fixed& operator-=(Fixed other) { return *this = *this - other; }
  friend constexpr Fixed operator+(Fixed a, Fixed b) { return from_raw(static_cast<Rep>(a.raw + b.raw)); }
  friend constexpr Fixed operator-(Fixed a, Fixed b) { return from_raw(static_cast<Rep>(a.raw - b.raw)); }
  friend constexpr auto operator<=>(Fixed, Fixed) = default;
};

inline constexpr int kUnitBits = 29;
inline constexpr int kLengthBits = 28;
using FixedUnit = Fixed<kUnitBits>;
using FixedLength = Fixed<kLengthBits>;

namespace detail {
constexpr std::int32_t times_unit(std::int32_t a, std::int32_t unit) {
  return static_cast<std::int32_t>((std::int64_t{a} * unit + (std::int64_t{1} << (kUnitBits - 1))) >>
                                   kUnitBits);
}
constexpr std::uint64_t magnitude(std::int64_t x) {
  return x < 0 ? -static_cast<std::uint64_t>(x) : static_cast<std::uint64_t>(x);
}
}  // namespace detail

constexpr FixedUnit operator*(FixedUnit a, FixedUnit b) {
  return FixedUnit::from_raw(detail::times_unit(a.raw, b.raw));
}
template <int B>
requires(B != kUnitBits) constexpr Fixed<B> operator*(Fixed<B> a, FixedUnit b) {
  return Fixed<B>::from_raw(detail::times_unit(a.raw, b.raw));
}
template <int B>
requires(B != kUnitBits) constexpr Fixed<B> operator*(FixedUnit b, Fixed<B> a) { return a * b; }
constexpr FixedUnit& operator*=(FixedUnit& a, FixedUnit b) { return a = a * b; }
/// Length times Length: exact.
template <int B>
requires(B != kUnitBits) constexpr Fixed<2 * B, std::int64_t> operator*(Fixed<B> a, Fixed<B> b) {
  return Fixed<2 * B, std::int64_t>::from_raw(std::int64_t{a.raw} * b.raw);
}
/// Unit squared: exact, for sums in which small squares must not vanish.
constexpr Fixed<2 * kUnitBits, std::int64_t> square(FixedUnit a) {
  return Fixed<2 * kUnitBits, std::int64_t>::from_raw(std::int64_t{a.raw} * a.raw);
}

/// Saturates at Unit's range; x / 0 is the largest Unit of x's sign.
constexpr FixedUnit operator/(FixedUnit a, FixedUnit b) {
  if (b.raw == 0) return FixedUnit::from_raw(a.raw < 0 ? -INT32_MAX : INT32_MAX);
  const auto divisor = static_cast<std::uint32_t>(detail::magnitude(b.raw));
  const int shift = std::countl_zero(divisor);
  // a / b = a * 2^29 / (divisor * 2^shift) * 2^shift, and the reciprocal is scaled by 2^62
  const std::int64_t product = std::int64_t{a.raw} * (reciprocal_mantissa(divisor << shift) >> 1);
  const int down = 61 - kUnitBits - shift;
  const std::int64_t quotient = shift_right_rounded(product, down);
  return FixedUnit::from_raw(saturate_i32(b.raw < 0 ? -quotient : quotient));
}
/// For |a| <= |b|, as barycentrics need it.
template <int B>
constexpr FixedUnit operator/(Fixed<B, std::int64_t> a, Fixed<B, std::int64_t> b) {
  const std::uint64_t numerator = detail::magnitude(a.raw);
  const std::uint64_t divisor = detail::magnitude(b.raw);
  const int shift = std::countl_zero(divisor);
  const auto n = static_cast<std::uint32_t>((numerator << shift) >> 32);
  const auto d = static_cast<std::uint32_t>((divisor << shift) >> 32);
  constexpr int kDown = 62 - kUnitBits;
  const auto quotient = static_cast<std::int32_t>(
      (std::uint64_t{n} * reciprocal_mantissa(d) + (std::uint64_t{1} << (kDown - 1))) >> kDown);
  return FixedUnit::from_raw((a.raw < 0) != (b.raw < 0) ? -quotient : quotient);
}

constexpr FixedUnit abs(FixedUnit a) { return a.raw < 0 ? -a : a; }

/// Square root; 0 for negative arguments.
constexpr FixedUnit sqrt(FixedUnit x) {
  if (x.raw <= 0) return FixedUnit::from_raw(0);
  const auto m = static_cast<std::uint32_t>(x.raw);
  // An odd number of digits behind the point: an odd shift makes m * 2^-(29 + shift) have an even exponent.
  int shift = std::countl_zero(m);
  if (shift % 2 == 0) --shift;
  const std::uint32_t normal = m << shift;  // in [2^30, 2^32)
  const std::uint64_t root =
      (std::uint64_t{normal} * rsqrt_mantissa(normal)) >> 31;  // sqrt(normal 2^-30) 2^30
  return FixedUnit::from_raw(
      static_cast<std::int32_t>(shift_right_rounded(static_cast<std::int64_t>(root), (shift + 1) / 2)));
}

/// 1 / d of a direction's component, for slabs: a signed mantissa and a shift, since it may be far beyond any
/// Fixed.
struct FixedInverse {
  std::int32_t mantissa = 0;  ///< in +-[2^29, 2^30]
  int shift = 0;              ///< 1 / d = mantissa * 2^-shift

  constexpr explicit FixedInverse(FixedUnit d) {
    // 0 is taken for the smallest Unit: any distance along it then saturates, which is what a slab needs.
    const auto m = static_cast<std::uint32_t>(d.raw == 0 ? 1 : detail::magnitude(d.raw));
    const int zeros = std::countl_zero(m);
    const auto reciprocal = static_cast<std::int32_t>(reciprocal_mantissa(m << zeros) >> 1);
    mantissa = d.raw < 0 ? -reciprocal : reciprocal;
    shift = 61 - kUnitBits - zeros;
  }
};

/// Saturates.
constexpr FixedLength operator*(FixedLength a, FixedInverse b) {
  return FixedLength::from_raw(saturate_i32((std::int64_t{a.raw} * b.mantissa) >> b.shift));
}

}  // namespace vitrine
