#include "lights/light_emission.h"

#include <cmath>
#include <numbers>

namespace vitrine {
namespace {

constexpr double kPi = std::numbers::pi;

// The largest intensity of a mesh, over its own mean normal and the directions to the faces, edges and
// corners of a cube, between which the intensity of a closed mesh hardly changes.
double largest_intensity(std::span<const LightFacet> facets, bool two_sided, const glm::dvec3& mean_normal) {
  const auto towards = [&](const glm::dvec3& w) {
    double sum = 0.0;
    for (const LightFacet& f : facets) {
      const double cosine = glm::dot(f.normal, w);
      sum += f.area * f.luminance * (two_sided ? std::abs(cosine) : std::max(0.0, cosine));
    }
    return sum;
  };
  double largest = glm::length(mean_normal) > 0.0 ? towards(glm::normalize(mean_normal)) : 0.0;
  for (int i = 0; i < 27; ++i) {
    const glm::dvec3 corner(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (i != 13) largest = std::max(largest, towards(glm::normalize(corner)));
  }
  return largest;
}

}  // namespace

LightEmission mesh_emission(std::span<const LightFacet> facets, bool two_sided) {
  LightEmission light{.two_sided = two_sided};
  glm::dvec3 mean_normal(0.0);
  bool first = true;
  for (const LightFacet& f : facets) {
    light.power += kPi * f.area * f.luminance * (two_sided ? 2.0 : 1.0);
    for (const glm::dvec3& corner : f.corners) light.bounds.grow(corner);
    // Of a two-sided light either normal will do: the one that widens the cone least.
    const bool turned = two_sided && !first && glm::dot(f.normal, light.cone.axis) < 0.0;
    const Cone normal{turned ? -f.normal : f.normal, 1.0};
    mean_normal += normal.axis * (f.area * f.luminance);
    light.cone = first ? normal : united(light.cone, normal);
    first = false;
  }
  const glm::dvec3 center = 0.5 * (light.bounds.low + light.bounds.high);
  for (const LightFacet& f : facets) {
    for (const glm::dvec3& corner : f.corners)
      light.radius = std::max(light.radius, glm::length(corner - center));
  }
  light.intensity = largest_intensity(facets, two_sided, mean_normal);
  return light;
}

LightEmission point_emission(const glm::dvec3& position, double intensity) {
  LightEmission light{.power = 4.0 * kPi * intensity, .intensity = intensity};
  light.bounds.grow(position);
  return light;
}

LightEmission spot_emission(const glm::dvec3& position, double intensity, const glm::dvec3& axis,
                            double cos_inner, double cos_outer) {
  LightEmission light{.intensity = intensity, .cone = {axis, cos_inner}};
  light.power = 2.0 * kPi * intensity * ((1.0 - cos_inner) + (cos_inner - cos_outer) / 3.0);
  light.bounds.grow(position);
  light.cos_spread = std::cos(std::acos(cos_outer) - std::acos(cos_inner));
  return light;
}

LightEmission directional_emission(const glm::dvec3& wi, double illuminance, double scene_radius) {
  return {
      .power = kPi * scene_radius * scene_radius * illuminance, .intensity = illuminance, .cone = {wi, 1.0}};
}

LightEmission environment_emission(double mean_luminance, double scene_radius) {
  return {.power = 4.0 * kPi * kPi * scene_radius * scene_radius * mean_luminance,
          .intensity = kPi * mean_luminance};
}

}  // namespace vitrine
