// A cone of directions on the host's arithmetic, and the smallest one around two (pbrt-v4, DirectionCone).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/glm.hpp>

namespace vitrine {

/// All directions unless told otherwise.
struct Cone {
  glm::dvec3 axis{0.0, 0.0, 1.0};  ///< unit
  double cos_half = -1.0;          ///< of the angle between the axis and the rim
};

inline Cone united(const Cone& a, const Cone& b) {
  const Cone& wide = a.cos_half < b.cos_half ? a : b;
  const Cone& narrow = a.cos_half < b.cos_half ? b : a;
  const double cos_between = std::clamp(glm::dot(a.axis, b.axis), -1.0, 1.0);
  if (wide.cos_half <= -1.0 || cos_between >= 1.0) return wide;
  const double wide_half = std::acos(wide.cos_half);
  const double narrow_half = std::acos(std::min(1.0, narrow.cos_half));
  const double between = std::acos(cos_between);
  if (between + narrow_half <= wide_half) return wide;
  const double half = (wide_half + between + narrow_half) / 2.0;
  if (half >= std::numbers::pi) return {};
  const glm::dvec3 across = narrow.axis - wide.axis * cos_between;  // the axis turns from the wide one's
  const double length = glm::length(across);
  if (!(length > 0.0)) return {};
  const double turn = half - wide_half;
  return {wide.axis * std::cos(turn) + across * (std::sin(turn) / length), std::cos(half)};
}

}  // namespace vitrine
