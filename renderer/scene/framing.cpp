#include "scene/framing.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace vitrine {

Bounds world_bounds(const Scene& scene) {
  Bounds bounds;
  for (const Instance& instance : scene.instances) {
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
      for (const glm::vec3& position : primitive.positions) {
        bounds.grow(glm::dvec3(instance.to_world * glm::dvec4(position, 1.0)));
      }
    }
  }
  return bounds;
}

CameraView framing_camera(const Bounds& bounds) {
  constexpr double kYfov_rad = 0.7;
  constexpr double kMargin = 1.05;
  const glm::dvec3 kTowardsViewer = glm::normalize(glm::dvec3(0.7, 0.45, 1.0));

  const glm::dvec3 center = 0.5 * (bounds.low + bounds.high);
  const double radius = 0.5 * glm::length(bounds.high - bounds.low);
  const double distance = kMargin * radius / std::sin(0.5 * kYfov_rad);
  CameraView view;
  view.name = "auto";
  view.yfov_rad = kYfov_rad;
  view.aspect = 1.0;
  view.to_world =
      glm::inverse(glm::lookAt(center + distance * kTowardsViewer, center, glm::dvec3(0.0, 1.0, 0.0)));
  return view;
}

}  // namespace vitrine
