#include "scene/light_emissions.h"

#include <algorithm>

#include "numeric/color.h"
#include "numeric/fixed_numbers.h"
#include "numeric/float_numbers.h"
#include "numeric/host_conversion.h"

namespace vitrine {
namespace {

template <class N>
double luminance_of(const Vec3<typename N::Radiance>& radiance) {
  return luminance<double>(to_host(radiance));
}

// Mean luminance of a triangle: of a texture, that of the midpoints of 64 equal parts. Small bright marks may
// lie between them, so it is never taken for dark.
template <class N>
double mean_luminance(const World<N>& world, std::uint32_t triangle) {
  constexpr int kParts = 8;  // of a side
  constexpr double kLeast = 1.0 / 256.0;
  const auto& material = world.material(triangle);
  const double most = luminance_of<N>(material.emission);
  if (!material.emission_texture) return most;
  double sum = 0.0;
  for (int i = 0; i < kParts; ++i) {
    for (int j = 0; j < kParts; ++j) {
      // Each cell of the unit square is half a cell below the diagonal, and half a cell to be folded there.
      const bool fold = i + j >= kParts;
      const double u = (fold ? kParts - i - 1.0 / 3.0 : i + 1.0 / 3.0) / kParts;
      const double v = (fold ? kParts - j - 1.0 / 3.0 : j + 1.0 / 3.0) / kParts;
      sum += luminance_of<N>(
          world.emitted(triangle, from_host<typename N::Unit>(u), from_host<typename N::Unit>(v)));
    }
  }
  return std::max(sum / (kParts * kParts), most * kLeast);
}

template <class N>
LightEmission emission_of(const World<N>& world, const MeshLight<N>& light) {
  std::vector<LightFacet> facets;
  facets.reserve(light.triangles().size());
  for (const EmissiveTriangle<N>& t : light.triangles()) {
    const glm::dvec3 corner = to_host(t.corner);
    facets.push_back({.corners = {corner, corner + to_host(t.edge_u), corner + to_host(t.edge_v)},
                      .normal = to_host(t.normal),
                      .area = t.area,
                      .luminance = mean_luminance(world, t.triangle)});
  }
  return mesh_emission(facets, light.two_sided());
}

template <class N>
LightEmission emission_of(const PointLight<N>& light) {
  const double intensity = luminance_of<N>(light.intensity);
  if (!light.spot) return point_emission(to_host(light.position), intensity);
  const double cos_outer = to_host(light.cos_outer);
  return spot_emission(to_host(light.position), intensity, to_host(light.axis),
                       cos_outer + 1.0 / to_host(light.cone_scale), cos_outer);
}

// Of a ball around everything that can be hit.
template <class N>
double radius_of(const World<N>& world) {
  Bounds bounds;
  for (const auto& p : world.bvh.positions()) bounds.grow(to_host(p));
  return 0.5 * glm::length(bounds.high - bounds.low);
}

}  // namespace

template <class N>
std::vector<LightEmission> light_emissions(const World<N>& world) {
  const double radius = radius_of(world);
  std::vector<LightEmission> lights;
  lights.reserve(world.lights.size());
  for (const auto& light : world.lights.meshes) lights.push_back(emission_of(world, light));
  for (const auto& light : world.lights.points) lights.push_back(emission_of<N>(light));
  for (const auto& light : world.lights.directional) {
    lights.push_back(directional_emission(to_host(light.wi), luminance_of<N>(light.irradiance), radius));
  }
  if (const auto& sky = world.lights.sky) {
    lights.push_back(environment_emission(sky->mean_luminance(), radius));
  }
  return lights;
}

template std::vector<LightEmission> light_emissions(const World<FloatNumbers>&);
template std::vector<LightEmission> light_emissions(const World<FixedNumbers>&);

}  // namespace vitrine
