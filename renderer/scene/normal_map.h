// Normals from a texture (glTF 2.0, section 3.9.3): (x, y, z) in the frame of tangent, bitangent and the
// surface's own normal, of which the texel says 2 c - 1.
#pragma once

#include "materials/texture.h"
#include "scene/surface_coordinates.h"

namespace vitrine {

/// Of a vertex. (0,0,0): none.
template <class N>
struct Tangent {
  Vec3<typename N::Unit> direction;  ///< unit, along growing u
  typename N::Unit side;             ///< +-1: the bitangent is side cross(normal, direction)
};

template <class N>
struct NormalMap {
  using Unit = typename N::Unit;

  Texture<N> texture;
  Vec3<Unit> scale;  ///< of x, y, z

  /// The normal at a point where the surface's own is `n` and its tangent `t`, of any length, that need not
  /// be perpendicular. `n` itself where there is no such frame.
  [[nodiscard]] Vec3<Unit> normal(const Vec3<Unit>& n, const Vec3<Unit>& t, Unit side,
                                  const SurfaceCoordinates<N>& at, const TexelTable<N>& linear) const {
    constexpr Unit kShortest = Unit(0.0001);  // squared
    const Vec3<Unit> across = t - n * dot(n, t);
    if (!(dot(across, across) > kShortest)) return n;
    const Vec3<Unit> texel = texture.sample(at.uv(texture.uv_set), linear);
    const Vec3<Unit> local = (texel + texel - Vec3<Unit>(1)) * scale;
    const Vec3<Unit> tangent = normalize(across);
    const Vec3<Unit> mapped = tangent * local.x + cross(n, tangent) * (side * local.y) + n * local.z;
    return dot(mapped, mapped) > kShortest ? normalize(mapped) : n;
  }
};

}  // namespace vitrine
