// Wide: a non-negative number of huge range in integers, for what no Q format can hold: densities,
// throughput, radiance. mantissa * 2^exponent with the mantissa normalised to [2^31, 2^32) by counting
// leading zeros; relative error of a product 2^-31, of a quotient 2^-29.
#pragma once

#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "numeric/fixed.h"

namespace vitrine {

struct Wide {
  std::uint32_t mantissa;  ///< 0 only for zero
  std::int32_t exponent;

  /// Zero's exponent: below every other, so that comparison needs no special case.
  static constexpr std::int32_t kZeroExponent = -(1 << 28);
  /// What stands for a division by zero; see is_finite().
  static constexpr std::int32_t kHugeExponent = 1 << 12;

  Wide() = default;
  /// Constants only; negative ones do not compile.
  consteval explicit Wide(double value) : mantissa(0), exponent(kZeroExponent) {
    if (value < 0) throw "a Wide is not negative";
    if (value == 0) return;
    exponent = 0;
    for (; value >= 4294967296.0; value /= 2) ++exponent;
    for (; value < 2147483648.0; value *= 2) --exponent;
    mantissa = static_cast<std::uint32_t>(value);
  }
  template <std::same_as<int> I>
  consteval Wide(I value) : Wide(static_cast<double>(value)) {}  // NOLINT: implicit on purpose
  /// Negative numbers become zero.
  template <int B, class Rep>
  constexpr explicit Wide(Fixed<B, Rep> x)
      : Wide(x.raw <= 0 ? zero() : normalized(static_cast<std::uint64_t>(x.raw), -B)) {}

  static constexpr Wide zero() { return {0, kZeroExponent, Parts{}}; }
  static constexpr Wide huge() { return {0xffffffffU, kHugeExponent, Parts{}}; }
  /// x * 2^exponent, truncated to 32 digits.
  static constexpr Wide normalized(std::uint64_t x, std::int32_t exponent) {
    if (x == 0) return zero();
    const int shift = std::countl_zero(x);
    return {static_cast<std::uint32_t>((x << shift) >> 32), exponent + 32 - shift, Parts{}};
  }

  /// Rounded to nearest, saturated.
  template <int B>
  [[nodiscard]] constexpr Fixed<B> to_fixed() const {
    const std::int32_t shift = -(exponent + B);
    if (mantissa == 0 || shift > 32) return Fixed<B>::from_raw(0);
    if (shift <= 0) return Fixed<B>::from_raw(INT32_MAX);
    return Fixed<B>::from_raw(saturate_i32(shift_right_rounded(std::int64_t{mantissa}, shift)));
  }
  constexpr explicit operator FixedUnit() const { return to_fixed<kUnitBits>(); }

  friend constexpr Wide operator*(Wide a, Wide b) {
    return normalized_product(std::uint64_t{a.mantissa} * b.mantissa, a.exponent + b.exponent);
  }
  friend constexpr Wide operator/(Wide a, Wide b) {
    if (a.mantissa == 0) return zero();
    if (b.mantissa == 0) return huge();
    return normalized_product(std::uint64_t{a.mantissa} * reciprocal_mantissa(b.mantissa) << 1,
                              a.exponent - b.exponent - 63);
  }
  friend constexpr Wide operator+(Wide a, Wide b) {
    if (a.exponent < b.exponent) std::swap(a, b);
    const std::int32_t shift = a.exponent - b.exponent;
    if (shift > 31) return a;
    const std::uint64_t sum = std::uint64_t{a.mantissa} + (b.mantissa >> shift);
    if ((sum >> 32) == 0) return {static_cast<std::uint32_t>(sum), a.exponent, Parts{}};
    return {static_cast<std::uint32_t>(sum >> 1), a.exponent + 1, Parts{}};
  }
  constexpr Wide& operator+=(Wide other) { return *this = *this + other; }
  constexpr Wide& operator*=(Wide other) { return *this = *this * other; }
  friend constexpr bool operator==(Wide, Wide) = default;
  friend constexpr auto operator<=>(Wide a, Wide b) {
    return a.exponent != b.exponent ? a.exponent <=> b.exponent : a.mantissa <=> b.mantissa;
  }

 private:
  struct Parts {};
  constexpr Wide(std::uint32_t m, std::int32_t e, Parts) : mantissa(m), exponent(e) {}

  /// product * 2^exponent for a product of two normalised mantissas, in [2^62, 2^64), or 0.
  static constexpr Wide normalized_product(std::uint64_t product, std::int32_t exponent) {
    if (product == 0) return zero();
    if ((product >> 63) != 0) return {static_cast<std::uint32_t>(product >> 32), exponent + 32, Parts{}};
    return {static_cast<std::uint32_t>(product >> 31), exponent + 31, Parts{}};
  }
};

constexpr Wide operator*(Wide a, FixedUnit b) { return a * Wide(b); }
constexpr Wide operator*(FixedUnit a, Wide b) { return Wide(a) * b; }
constexpr Wide operator/(Wide a, FixedUnit b) { return a / Wide(b); }

/// a - b, or zero where that would be negative.
constexpr Wide excess(Wide a, Wide b) {
  if (!(a > b)) return Wide::zero();
  const std::int32_t shift = a.exponent - b.exponent;
  if (shift > 31) return a;
  const std::uint64_t difference =
      (std::uint64_t{a.mantissa} << 31) - ((std::uint64_t{b.mantissa} << 31) >> shift);
  return Wide::normalized(difference, a.exponent - 31);
}

/// Relative error 2^-29.
constexpr Wide sqrt(Wide x) {
  if (x.mantissa == 0) return x;
  const bool odd = (x.exponent & 1) != 0;  // a root of a power of two asks for an even exponent
  const std::uint32_t mantissa = odd ? x.mantissa >> 1 : x.mantissa;
  const std::int32_t exponent = odd ? x.exponent + 1 : x.exponent;
  return Wide::normalized(std::uint64_t{mantissa} * rsqrt_mantissa(mantissa), exponent / 2 - 46);
}

/// False for what a division by zero led to: no honest quantity of a scene reaches 2^1000.
constexpr bool is_finite(Wide x) { return x.exponent < 1000; }

}  // namespace vitrine
