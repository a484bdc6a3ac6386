// Rays and hits, as drivers and kernels pass them in batches.
#pragma once

#include <cstdint>

#include "numeric/vec.h"

namespace vitrine {

template <class N>
struct Ray {
  Vec3<typename N::Length> origin;
  Vec3<typename N::Unit> direction;  ///< unit
  typename N::Length t_max;          ///< hits at or beyond it do not count
};

/// Beyond every hit: a baked scene lies within +-1, so no two points of it are farther apart than 2 sqrt(3).
template <class N>
constexpr typename N::Length far_away() {
  return typename N::Length(7);
}

/// How far a ray's origin is moved off its surface along the geometric normal, in baked units (the scene's
/// half extent). A point on a triangle is off by about 2^-22 in float, 2^-27 in fixed point.
template <class N>
constexpr typename N::Length ray_offset() {
  return typename N::Length(0x1p-17);
}

inline constexpr std::uint32_t kNoTriangle = 0xffffffffU;

template <class N>
struct Hit {
  typename N::Length t{};
  typename N::Unit u{};  ///< barycentric weight of the triangle's second corner
  typename N::Unit v{};  ///< of its third
  std::uint32_t triangle = kNoTriangle;

  explicit operator bool() const { return triangle != kNoTriangle; }
};

}  // namespace vitrine
