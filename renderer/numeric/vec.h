// GLM vectors over both number systems. GLM gives the operators of one type; here are those that mix types
// and the geometric functions for fixed point, beside GLM's own for float. Found by argument-dependent
// lookup.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>

#include <glm/glm.hpp>

#include "numeric/fixed.h"
#include "numeric/float_math.h"
#include "numeric/wide.h"

namespace vitrine {

template <class R>
using Vec2 = glm::vec<2, R, glm::defaultp>;
template <class R>
using Vec3 = glm::vec<3, R, glm::defaultp>;

namespace detail {
template <class T>
inline constexpr bool kIsOurs = false;
template <int B, class Rep>
inline constexpr bool kIsOurs<Fixed<B, Rep>> = true;
template <>
inline constexpr bool kIsOurs<Wide> = true;
template <class A, class B>
concept MixedQuantities = kIsOurs<A> && kIsOurs<B> && !std::same_as<A, B>;

/// a . a in units of 2^-2B, without loss.
template <int B>
constexpr std::int64_t exact_dot(const Vec3<Fixed<B>>& a, const Vec3<Fixed<B>>& b) {
  return std::int64_t{a.x.raw} * b.x.raw + std::int64_t{a.y.raw} * b.y.raw + std::int64_t{a.z.raw} * b.z.raw;
}
}  // namespace detail

template <class A, class B>
requires detail::MixedQuantities<A, B>
constexpr auto operator*(const Vec3<A>& a, B b) { return Vec3<decltype(a.x * b)>(a.x * b, a.y * b, a.z * b); }
template <class A, class B>
requires detail::MixedQuantities<A, B>
constexpr auto operator*(const Vec3<A>& a, const Vec3<B>& b) {
  return Vec3<decltype(a.x * b.x)>(a.x * b.x, a.y * b.y, a.z * b.z);
}
template <class A, class B>
requires detail::MixedQuantities<A, B>
constexpr auto operator/(const Vec3<A>& a, B b) { return Vec3<decltype(a.x / b)>(a.x / b, a.y / b, a.z / b); }
template <class A, class B>
requires detail::MixedQuantities<A, B>
constexpr auto operator*(const Vec2<A>& a, B b) { return Vec2<decltype(a.x * b)>(a.x * b, a.y * b); }

constexpr FixedUnit dot(const Vec3<FixedUnit>& a, const Vec3<FixedUnit>& b) {
  return FixedUnit::from_raw(
      static_cast<std::int32_t>(shift_right_rounded(detail::exact_dot(a, b), kUnitBits)));
}
template <int B>
requires(B != kUnitBits) constexpr Fixed<2 * B, std::int64_t> dot(const Vec3<Fixed<B>>& a,
                                                                  const Vec3<Fixed<B>>& b) {
  return Fixed<2 * B, std::int64_t>::from_raw(detail::exact_dot(a, b));
}

constexpr Vec3<FixedUnit> cross(const Vec3<FixedUnit>& a, const Vec3<FixedUnit>& b) {
  const auto minor = [](FixedUnit p, FixedUnit q, FixedUnit r, FixedUnit s) {
    const std::int64_t exact = std::int64_t{p.raw} * q.raw - std::int64_t{r.raw} * s.raw;
    return FixedUnit::from_raw(static_cast<std::int32_t>(shift_right_rounded(exact, kUnitBits)));
  };
  return {minor(a.y, b.z, b.y, a.z), minor(a.z, b.x, b.z, a.x), minor(a.x, b.y, b.x, a.y)};
}

/// The unit vector along `a`; (0,0,0) for a zero vector.
template <int B>
constexpr Vec3<FixedUnit> normalize(const Vec3<Fixed<B>>& a) {
  const auto squared = static_cast<std::uint64_t>(detail::exact_dot(a, a));
  if (squared == 0) return Vec3<FixedUnit>(0);
  const int zeros = std::countl_zero(squared) & ~1;
  const auto y =
      static_cast<std::int64_t>(rsqrt_mantissa(static_cast<std::uint32_t>((squared << zeros) >> 32)));
  // 1 / |a| = y 2^-31 2^-(62 - zeros) / 2 in units of 2^B: the components come out with 29 digits
  const int down = 31 + (62 - zeros) / 2 - kUnitBits;
  const auto scale = [&](Fixed<B> c) {
    return FixedUnit::from_raw(static_cast<std::int32_t>(shift_right_rounded(c.raw * y, down)));
  };
  return {scale(a.x), scale(a.y), scale(a.z)};
}

template <int B>
constexpr Fixed<B> length(const Vec3<Fixed<B>>& a) {
  const auto squared = static_cast<std::uint64_t>(detail::exact_dot(a, a));
  if (squared == 0) return Fixed<B>::from_raw(0);
  const int zeros = std::countl_zero(squared) & ~1;
  const auto m = static_cast<std::uint32_t>((squared << zeros) >> 32);
  const auto root = static_cast<std::int64_t>((std::uint64_t{m} * rsqrt_mantissa(m)) >> 31);
  return Fixed<B>::from_raw(saturate_i32(shift_right_rounded(root, 30 - (62 - zeros) / 2)));
}

/// The largest component.
template <class T>
constexpr T max_component(const Vec3<T>& v) {
  const T& xy = v.x < v.y ? v.y : v.x;
  return xy < v.z ? v.z : xy;
}

}  // namespace vitrine
