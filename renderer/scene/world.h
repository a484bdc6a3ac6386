// The world that is traced: a scene in one number system, flat, by index, immutable. Lengths are scaled so
// that everything lies within +-1 of the centre, radiance so that the brightest light is about 1.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/bvh.h"
#include "lights/light_list.h"
#include "lights/uniform_light_selection.h"
#include "scene/baked_material.h"
#include "scene/scene.h"

namespace vitrine {

inline constexpr std::uint32_t kNoLight = 0xffffffffU;

/// A point of a surface that a ray met.
template <class N>
struct SurfacePoint {
  Vec3<typename N::Length> position;
  Vec3<typename N::Unit> geometric_normal;  ///< of the front side
  Vec3<typename N::Unit> normal;            ///< interpolated, of the front side
  std::uint32_t triangle;
};

template <class N>
struct World {
  using Unit = typename N::Unit;
  using Length = typename N::Length;
  using Radiance = typename N::Radiance;

  struct TriangleInfo {
    Vec3<Unit> normal;  ///< geometric, of the front side
    std::uint32_t material = 0;
    std::uint32_t light = kNoLight;    ///< index into lights.meshes
    std::uint32_t light_triangle = 0;  ///< index within that light
  };

  Bvh<N> bvh;
  std::vector<TriangleInfo> triangles;  ///< as bvh.triangles()
  std::vector<Vec3<Unit>> normals;      ///< a vertex; (0,0,0): flat
  std::vector<UvSet<N>> uv_sets;        ///< a pair of texcoord set and transform each
  std::vector<Vec3<Unit>> colors;       ///< a vertex; empty: white
  std::vector<BakedMaterial<N>> materials;
  std::vector<Image> images;  ///< the textures point into them
  TexelTable<N> srgb_table;
  TexelTable<N> linear_table;
  LightList<N> lights;
  UniformLightSelection<N> light_selection;
  int exponent = 0;        ///< radiance 1 is 2^exponent nits
  glm::dvec3 center{0.0};  ///< of the baked box, metres
  double scale = 1.0;      ///< baked lengths per metre

  World() = default;
  World(World&&) noexcept = default;
  World& operator=(World&&) noexcept = default;
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  [[nodiscard]] SurfacePoint<N> surface_point(const Hit<N>& hit) const {
    const glm::uvec3& corners = bvh.triangles()[hit.triangle];
    const auto positions = bvh.positions();
    const Vec3<Length>& a = positions[corners.x];
    const TriangleInfo& info = triangles[hit.triangle];
    SurfacePoint<N> point{
        .position = a + (positions[corners.y] - a) * hit.u + (positions[corners.z] - a) * hit.v,
        .geometric_normal = info.normal,
        .normal = info.normal,
        .triangle = hit.triangle};
    const Vec3<Unit> smooth =
        normals[corners.x] * (1 - hit.u - hit.v) + normals[corners.y] * hit.u + normals[corners.z] * hit.v;
    if (dot(smooth, smooth) > Unit(0.01)) {
      point.normal = normalize(smooth);
      // A normal that disagrees with the winding is taken for one that points the wrong way.
      if (dot(point.normal, info.normal) < 0) point.normal = -point.normal;
    }
    return point;
  }

  [[nodiscard]] SurfaceCoordinates<N> coordinates(std::uint32_t triangle, Unit u, Unit v) const {
    const glm::uvec3& corners = bvh.triangles()[triangle];
    const Vec3<Unit> weights(1 - u - v, u, v);
    SurfaceCoordinates<N> at{uv_sets, corners, weights, Vec3<Unit>(1)};
    if (!colors.empty()) {
      at.color =
          colors[corners.x] * weights.x + colors[corners.y] * weights.y + colors[corners.z] * weights.z;
    }
    return at;
  }

  [[nodiscard]] const BakedMaterial<N>& material(std::uint32_t triangle) const {
    return materials[triangles[triangle].material];
  }

  /// Radiance that `triangle` sends out at the barycentrics u, v.
  [[nodiscard]] Vec3<Radiance> emitted(std::uint32_t triangle, Unit u, Unit v) const {
    const BakedMaterial<N>& m = material(triangle);
    if (!m.emission_texture) return m.emission;
    return m.emitted(coordinates(triangle, u, v), srgb_table);
  }
};

}  // namespace vitrine
