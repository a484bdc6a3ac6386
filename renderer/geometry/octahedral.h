// Directions on a square: the sphere is drawn onto an octahedron, whose half behind is folded out around the
// half in front (Praun, Hoppe 2003). Only adding and dividing, no angle, and no seam but the rim of the
// square, where a point is the same direction as its mirror image in the middle of its side. The horizon
// y = 0 is straight: the middle line, and the sides x = -1 and x = 1.
//
//   p = w / (|w.x| + |w.y| + |w.z|);   (x, y) = (p.x, p.y) if p.z >= 0, else folded over |x| + |y| = 1
//   pdf_w = pdf_xy |p|^3 = pdf_xy / (|w.x| + |w.y| + |w.z|)^3
#pragma once

#include "numeric/vec.h"

namespace vitrine {

/// `Unit`: the scalar of a number system, or double on the host.
template <class Unit>
struct OctahedralPoint {
  Unit x;            ///< in [-1, 1]
  Unit y;            ///< in [-1, 1]
  Unit taxicab = 1;  ///< |w.x| + |w.y| + |w.z| of the unit direction, in [1, sqrt(3)]
};

namespace detail {
template <class Unit>
constexpr Unit magnitude_of(Unit x) {
  return x < 0 ? -x : x;
}
/// (x, y) mirrored in the diagonal |x| + |y| = 1 of its quadrant.
template <class Unit>
constexpr Vec2<Unit> folded(Unit x, Unit y) {
  const Unit rest_x = 1 - magnitude_of(y);
  const Unit rest_y = 1 - magnitude_of(x);
  return {x < 0 ? -rest_x : rest_x, y < 0 ? -rest_y : rest_y};
}
}  // namespace detail

/// Where the unit direction `w` lies on the square.
template <class Unit>
constexpr OctahedralPoint<Unit> octahedral_point(const Vec3<Unit>& w) {
  const Unit taxicab = detail::magnitude_of(w.x) + detail::magnitude_of(w.y) + detail::magnitude_of(w.z);
  const Unit x = w.x / taxicab;
  const Unit y = w.y / taxicab;
  if (!(w.z < 0)) return {x, y, taxicab};
  const Vec2<Unit> outside = detail::folded(x, y);
  return {outside.x, outside.y, taxicab};
}

/// The unit direction at a point of the square.
template <class Unit>
constexpr Vec3<Unit> octahedral_direction(Unit x, Unit y) {
  const Unit z = 1 - detail::magnitude_of(x) - detail::magnitude_of(y);
  if (!(z < 0)) return normalize(Vec3<Unit>(x, y, z));
  const Vec2<Unit> inside = detail::folded(x, y);
  return normalize(Vec3<Unit>(inside.x, inside.y, z));
}

}  // namespace vitrine
