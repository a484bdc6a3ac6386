// The camera as rays are made from it: a point of the film plane is a corner plus two edges, either as
// directions (perspective) or as origins (orthographic).
#pragma once

#include <cstdint>

#include "geometry/ray.h"

namespace vitrine {

template <class N>
struct Camera {
  using Unit = typename N::Unit;
  using Length = typename N::Length;

  bool orthographic = false;
  Vec3<Length> origin;       ///< perspective: the eye
  Vec3<Unit> direction;      ///< orthographic: where every ray goes
  Vec3<Unit> corner;         ///< perspective: the direction of the film's top left corner, not normalised
  Vec3<Unit> right;          ///< along the film's width
  Vec3<Unit> down;           ///< along its height
  Vec3<Length> film_corner;  ///< orthographic: the same as points
  Vec3<Length> film_right;
  Vec3<Length> film_down;
  decltype(N::pixel_step(1)) step_x;
  decltype(N::pixel_step(1)) step_y;

  /// The ray through the point (u, v) in [0, 1)^2 of pixel (x, y); y runs downwards.
  [[nodiscard]] Ray<N> ray(std::uint32_t x, std::uint32_t y, Unit u, Unit v) const {
    const Unit s = N::pixel_coordinate(x, u, step_x);
    const Unit t = N::pixel_coordinate(y, v, step_y);
    if (orthographic) return {film_corner + film_right * s + film_down * t, direction, far_away<N>()};
    return {origin, normalize(corner + right * s + down * t), far_away<N>()};
  }
};

}  // namespace vitrine
