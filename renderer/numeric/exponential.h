// Powers for both number systems. The fixed ones are integers only: a number is split into a power of two and
// a rest near 1, of which a short series gives logarithm or exponential.
//
//   x = 2^e f:  log2 f = 2 / ln 2 * atanh z,  z = (f - 1) / (f + 1)       f in [1 / sqrt 2, sqrt 2]: z^11
//   suffices 2^-x = 2^-floor(x) 2^-g,  2^-g = 2^-1/2 e^(-ln 2 (g - 1/2))           g in [0, 1): the 8th power
//   suffices
//
// Results are densities, since they may be far smaller than a Unit's resolution; Unit(...) rounds them to
// one.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "numeric/wide.h"

namespace vitrine {

/// e^-x, for x >= 0.
inline float exp_negative(float x) { return std::exp(-x); }
/// base^exponent, for a base in [0, 1] and an exponent >= 0; 0^0 is 1.
inline float pow(float base, float exponent) { return std::pow(base, exponent); }

namespace detail {

/// -log2(x) for x in (0, 1], within 2^-28.
constexpr Wide negative_log2(FixedUnit x) {
  const int zeros = std::countl_zero(static_cast<std::uint32_t>(x.raw));
  int exponent = 31 - kUnitBits - zeros;
  FixedUnit f = FixedUnit::from_raw(static_cast<std::int32_t>(static_cast<std::uint32_t>(x.raw) << zeros >>
                                                              (31 - kUnitBits)));  // in [1, 2)
  constexpr FixedUnit kRoot2(1.4142135623730951);
  if (f > kRoot2) {
    f = FixedUnit::from_raw(static_cast<std::int32_t>(shift_right_rounded(f.raw, 1)));
    ++exponent;
  }
  const FixedUnit z = (f - 1) / (f + 1);
  const FixedUnit y = z * z;
  FixedUnit p(0.2623081892525388);
  p = FixedUnit(0.3205988979753252) + y * p;
  p = FixedUnit(0.4121985831111324) + y * p;
  p = FixedUnit(0.5770780163555853) + y * p;
  p = FixedUnit(0.9617966939259756) + y * p;
  p = FixedUnit(2.8853900817779268) + y * p;
  const std::int64_t result = -(std::int64_t{exponent} << kUnitBits) - (z * p).raw;
  return result <= 0 ? Wide::zero() : Wide::normalized(static_cast<std::uint64_t>(result), -kUnitBits);
}

/// 2^-x, relative error 2^-27 (1 + x / 16); 0 beyond 2^-4096.
constexpr Wide exp2_negative(Wide x) {
  constexpr int kDigits = 29;  // behind the point of x
  if (x.exponent >= -19) return Wide::zero();
  if (x.exponent < -64) return Wide(1);
  const auto digits =
      static_cast<std::uint64_t>(shift_right_rounded(std::int64_t{x.mantissa}, -(x.exponent + kDigits)));
  if (digits == 0) return Wide(1);
  const auto whole = static_cast<std::int32_t>(digits >> kDigits);
  const FixedUnit rest =
      FixedUnit::from_raw(static_cast<std::int32_t>(digits & ((std::uint64_t{1} << kDigits) - 1)));
  const FixedUnit y = FixedUnit(0.5) - rest;
  FixedUnit p(0.0000009344760326);
  p = FixedUnit(0.0000107853115045) + y * p;
  p = FixedUnit(0.0001089194079537) + y * p;
  p = FixedUnit(0.0009428249382685) + y * p;
  p = FixedUnit(0.0068010443143318) + y * p;
  p = FixedUnit(0.0392473316206103) + y * p;
  p = FixedUnit(0.1698657920915375) + y * p;
  p = FixedUnit(0.4901290717342736) + y * p;
  p = FixedUnit(0.7071067811865476) + y * p;
  Wide result(p);
  result.exponent -= whole;
  return result;
}

}  // namespace detail

constexpr Wide exp_negative(Wide x) { return detail::exp2_negative(x * Wide(1.4426950408889634)); }
constexpr Wide pow(FixedUnit base, Wide exponent) {
  if (base.raw <= 0) return exponent.mantissa == 0 ? Wide(1) : Wide::zero();
  return detail::exp2_negative(exponent * detail::negative_log2(base));
}

}  // namespace vitrine
