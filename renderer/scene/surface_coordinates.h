// Where on a triangle a point is, and what the triangle's vertices say there.
#pragma once

#include <span>
#include <vector>

#include "numeric/vec.h"

namespace vitrine {

/// A texture coordinate of every vertex.
template <class N>
using UvSet = std::vector<Vec2<typename N::TexCoord>>;

template <class N>
struct SurfaceCoordinates {
  using Unit = typename N::Unit;

  std::span<const UvSet<N>> uv_sets;
  glm::uvec3 corners;  ///< vertices of the triangle
  Vec3<Unit> weights;  ///< their barycentric weights
  Vec3<Unit> color;    ///< of the vertices, multiplies the base colour
  Unit alpha;          ///< of the vertices, multiplies alpha

  /// What a vertex each has, blended.
  template <class T>
  [[nodiscard]] T blend(const std::vector<T>& of_vertices) const {
    return of_vertices[corners.x] * weights.x + of_vertices[corners.y] * weights.y +
           of_vertices[corners.z] * weights.z;
  }
  [[nodiscard]] Vec2<typename N::TexCoord> uv(int set) const {
    return blend(uv_sets[static_cast<std::size_t>(set)]);
  }
};

}  // namespace vitrine
