// What the selection of lights knows of a light, on the host's arithmetic: how much light it gives, from
// where and which way (Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights"; pbrt-v4,
// LightBounds).
//
//   power, for a choice that knows no receiver (pbrt-v4, Light::Phi)     intensity, what a receiver gets of
//   it mesh          pi sum of area luminance, twice if two-sided           the largest sum of area luminance
//   cos point         4 pi I                                                 I spot          I times the
//   integral of its falloff                    I directional   pi R^2 E, R the scene's radius E environment
//   4 pi^2 R^2 mean luminance                              pi mean luminance
#pragma once

#include <array>
#include <span>

#include "geometry/bounds.h"
#include "lights/cone.h"

namespace vitrine {

struct LightEmission {
  double power = 0.0;
  /// The largest luminous intensity of any direction, of all parts together; of a light that is infinitely
  /// far away, the illuminance on a surface that faces it.
  double intensity = 0.0;
  Bounds bounds{};      ///< empty: infinitely far away
  double radius = 0.0;  ///< of a ball around the bounds' centre that holds the light
  /// Near: each part of the light shines along some direction of this cone and up to `spread` around it. Far:
  /// the directions that lead to the light.
  Cone cone{};
  double cos_spread = 0.0;
  bool two_sided = false;  ///< near: shines along the opposite directions too

  [[nodiscard]] bool is_far() const { return bounds.low.x > bounds.high.x; }
};

/// A triangle of a mesh light.
struct LightFacet {
  std::array<glm::dvec3, 3> corners;
  glm::dvec3 normal;  ///< unit
  double area;
  double luminance;
};
LightEmission mesh_emission(std::span<const LightFacet> facets, bool two_sided);

LightEmission point_emission(const glm::dvec3& position, double intensity);
/// The falloff runs from 1 at cos_inner to 0 at cos_outer (punctual_light.h).
LightEmission spot_emission(const glm::dvec3& position, double intensity, const glm::dvec3& axis,
                            double cos_inner, double cos_outer);
LightEmission directional_emission(const glm::dvec3& wi, double illuminance, double scene_radius);
LightEmission environment_emission(double mean_luminance, double scene_radius);

}  // namespace vitrine
