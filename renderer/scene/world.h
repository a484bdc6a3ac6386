// The world that is traced: a scene in one number system, flat, by index, immutable. Lengths are scaled so
// that everything lies within +-1 of the centre, radiance so that the brightest light is about 1.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bvh.h"
#include "geometry/crossing.h"
#include "lights/light_list.h"
#include "lights/light_selection.h"
#include "scene/baked_material.h"
#include "scene/scene.h"

namespace vitrine {

inline constexpr std::uint32_t kNoLight = 0xffffffffU;
/// In place of a material: in none of the solids.
inline constexpr std::uint32_t kOutside = 0xffffffffU;

/// A point of a surface that a ray met.
template <class N>
struct SurfacePoint {
  Vec3<typename N::Length> position;
  Vec3<typename N::Unit> geometric_normal;  ///< of the front side
  Vec3<typename N::Unit> normal;            ///< interpolated or by a normal map, of the front side
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
  std::vector<Tangent<N>> tangents;     ///< a vertex; empty: there are no normal maps
  std::vector<Vec3<Unit>> colors;       ///< a vertex; empty: white
  std::vector<Unit> alphas;             ///< a vertex; empty: 1
  std::vector<BakedMaterial<N>> materials;
  std::vector<Image> images;  ///< the textures point into them
  TexelTable<N> srgb_table;
  TexelTable<N> linear_table;
  LightList<N> lights;
  LightSelectors<N> light_selectors;
  bool see_through = false;  ///< some material does not cover everything
  bool absorbs = false;      ///< some solid is not clear
  int exponent = 0;          ///< radiance 1 is 2^exponent nits
  glm::dvec3 center{0.0};    ///< of the baked box, metres
  double scale = 1.0;        ///< baked lengths per metre

  World() = default;
  World(World&&) noexcept = default;
  World& operator=(World&&) noexcept = default;
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// The first surface that stops each ray.
  void closest(std::span<const Ray<N>> rays, std::span<Hit<N>> hits) const {
    if (see_through) {
      bvh.closest(rays, hits, [this](const Ray<N>& ray, const Hit<N>& hit) { return stops(ray, hit); });
    } else {
      bvh.closest(rays, hits);
    }
  }
  /// Whether anything stops each ray: 1, or 0.
  void occluded(std::span<const Ray<N>> rays, std::span<std::uint8_t> occluded) const {
    if (see_through) {
      bvh.occluded(rays, occluded, [this](const Ray<N>& ray, const Hit<N>& hit) { return stops(ray, hit); });
    } else {
      bvh.occluded(rays, occluded);
    }
  }

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
    if (const auto& map = materials[info.material].normal_map) {
      const SurfaceCoordinates<N> at = coordinates(hit.triangle, hit.u, hit.v);
      const Vec3<Unit> tangent = tangents[corners.x].direction * at.weights.x +
                                 tangents[corners.y].direction * at.weights.y +
                                 tangents[corners.z].direction * at.weights.z;
      point.normal = map->normal(point.normal, tangent, tangents[corners.x].side, at, linear_table);
    }
    return point;
  }

  [[nodiscard]] SurfaceCoordinates<N> coordinates(std::uint32_t triangle, Unit u, Unit v) const {
    const glm::uvec3& corners = bvh.triangles()[triangle];
    const Vec3<Unit> weights(1 - u - v, u, v);
    SurfaceCoordinates<N> at{uv_sets, corners, weights, Vec3<Unit>(1), Unit(1)};
    if (!colors.empty()) at.color = at.blend(colors);
    if (!alphas.empty()) at.alpha = at.blend(alphas);
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

  /// The share of rays through that point of `triangle` that it stops.
  [[nodiscard]] Unit coverage(std::uint32_t triangle, Unit u, Unit v) const {
    const Coverage<N>& c = material(triangle).coverage;
    return c.complete ? Unit(1) : c.share(coordinates(triangle, u, v), linear_table);
  }

  /// What is left of light after `distance` within the solid of a material, or outside.
  [[nodiscard]] Vec3<typename N::Density> transmittance(std::uint32_t solid, Length distance) const {
    if (solid == kOutside || !materials[solid].absorption) return Vec3<typename N::Density>(1);
    return materials[solid].absorption.transmittance(distance);
  }

 private:
  [[nodiscard]] bool stops(const Ray<N>& ray, const Hit<N>& hit) const {
    const Unit share = coverage(hit.triangle, hit.u, hit.v);
    if (!(share < 1)) return true;
    return share > 0 && N::unit_from_bits(crossing_bits(ray, hit.triangle)) < share;
  }
};

}  // namespace vitrine
