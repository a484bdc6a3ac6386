// Irradiance in closed form: what a renderer's pictures of a lit plane are held against.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "geometry/octahedral.h"
#include "scene/environment_lattice.h"
#include "scene/scene.h"

namespace vitrine {

/// Of a polygon of radiance 1 on the point p with normal n, all of it above p's horizon (Lambert 1760):
/// 1/2 sum over the edges of the angle that it subtends times the cosine between n and its plane's normal.
inline double polygon_irradiance(std::span<const glm::dvec3> corners, const glm::dvec3& p,
                                 const glm::dvec3& n) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a = glm::normalize(corners[i] - p);
    const glm::dvec3 b = glm::normalize(corners[(i + 1) % corners.size()] - p);
    const glm::dvec3 across = glm::cross(a, b);
    sum += std::atan2(glm::length(across), glm::dot(a, b)) * glm::dot(n, glm::normalize(across));
  }
  return std::abs(sum) / 2.0;
}

/// Of a punctual light, by KHR_lights_punctual: I cos / d^2 times the falloff of a spot; lux cos.
inline glm::dvec3 punctual_irradiance(const PunctualLight& light, const glm::dvec3& p, const glm::dvec3& n) {
  const glm::dvec3 intensity(light.intensity);
  if (light.kind == PunctualKind::kDirectional)
    return intensity * std::max(0.0, -glm::dot(light.direction, n));
  const glm::dvec3 to_light = light.position - p;
  const glm::dvec3 wi = glm::normalize(to_light);
  double falloff = std::max(0.0, glm::dot(wi, n)) / glm::dot(to_light, to_light);
  if (light.kind == PunctualKind::kSpot) {
    const double cos_outer = std::cos(light.outer_cone_rad);
    const double cos_inner = std::cos(light.inner_cone_rad);
    const double ramp =
        std::clamp((-glm::dot(wi, light.direction) - cos_outer) / (cos_inner - cos_outer), 0.0, 1.0);
    falloff *= ramp * ramp;
  }
  return intensity * falloff;
}

/// Of a sky on the ground: 2 pi times the integral over the cosine c of (horizon (1 - c) + zenith c) c.
inline glm::dvec3 sky_irradiance(const Environment& sky) {
  const glm::dvec3 horizon(sky.horizon);
  return 2.0 * std::numbers::pi * (horizon / 2.0 + (glm::dvec3(sky.zenith) - horizon) / 3.0);
}

/// Of the map of a picture on the ground, by midpoints.
inline glm::dvec3 lattice_irradiance(const EnvironmentLattice& lattice) {
  constexpr int kPieces = 16;  // of a cell's side
  const int steps = lattice.cells * kPieces;
  glm::dvec3 sum(0.0);
  for (int row = 0; row < steps; ++row) {
    for (int column = 0; column < steps; ++column) {
      const double x = (column + 0.5) / kPieces;
      const double y = (row + 0.5) / kPieces;
      const glm::dvec3 w = octahedral_direction(2.0 * x / lattice.cells - 1.0, 2.0 * y / lattice.cells - 1.0);
      if (!(w.y > 0.0)) continue;
      const glm::dvec3* near =
          &lattice.radiance[static_cast<std::size_t>(row / kPieces * (lattice.cells + 1) + column / kPieces)];
      const glm::dvec3* far = near + lattice.cells + 1;
      const double u = x - column / kPieces;
      const double v = y - row / kPieces;
      sum += glm::mix(glm::mix(near[0], near[1], u), glm::mix(far[0], far[1], u), v) * w.y *
             std::pow(octahedral_point(w).taxicab, 3.0) * (4.0 / steps / steps);
    }
  }
  return sum;
}

}  // namespace vitrine
