// Scenes made in memory, a part at a time, for tests that know the answer in closed form.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace vitrine {

/// A pure Lambert surface.
inline Material matte(const glm::vec3& albedo) {
  Material material;
  material.base_color = albedo;
  material.metallic = 0.0F;
  material.specular = 0.0F;
  return material;
}

/// A black surface that emits `nits`.
inline Material lamp(const glm::vec3& nits, bool double_sided = false) {
  Material material = matte(glm::vec3(0.0F));
  material.emission = nits;
  material.double_sided = double_sided;
  return material;
}

/// The boundary of a solid of clear glass.
inline Material glass() {
  Material material;
  material.metallic = 0.0F;
  material.roughness = 0.0F;
  material.transmission = 1.0F;
  material.refracts = true;
  return material;
}

/// The parallelogram corner + [0, 1] u + [0, 1] v, whose front is where u x v points; with normals.
struct Quad {
  glm::dvec3 corner;
  glm::dvec3 u;
  glm::dvec3 v;

  [[nodiscard]] glm::dvec3 normal() const { return glm::normalize(glm::cross(u, v)); }
  [[nodiscard]] std::vector<glm::dvec3> corners() const {
    return {corner, corner + u, corner + u + v, corner + v};
  }
};

inline Mesh mesh_of(const Quad& quad, int material) {
  Primitive primitive;
  for (const glm::dvec3& p : quad.corners()) {
    primitive.positions.emplace_back(p);
    primitive.normals.emplace_back(quad.normal());
  }
  primitive.triangles = {{0, 1, 2}, {0, 2, 3}};
  primitive.material = material;
  return {.name = "quad", .primitives = {std::move(primitive)}};
}

/// Adds a mesh of its own, and an instance of it.
inline void place(Scene& scene, const Quad& quad, const Material& material,
                  const glm::dmat4& to_world = glm::dmat4(1.0)) {
  scene.materials.push_back(material);
  scene.meshes.push_back(mesh_of(quad, static_cast<int>(scene.materials.size()) - 1));
  scene.instances.push_back(
      {.name = "quad", .mesh = static_cast<int>(scene.meshes.size()) - 1, .to_world = to_world});
}

/// The six sides of the box [-half, half], facing inwards, as one mesh.
inline void place_room(Scene& scene, double half, const Material& material) {
  scene.materials.push_back(material);
  Mesh room;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Quad quad{glm::dvec3(-half), glm::dvec3(0.0), glm::dvec3(0.0)};
      quad.corner[axis] = side * half;
      quad.u[(axis + (side < 0 ? 1 : 2)) % 3] = 2.0 * half;
      quad.v[(axis + (side < 0 ? 2 : 1)) % 3] = 2.0 * half;
      room.primitives.push_back(
          mesh_of(quad, static_cast<int>(scene.materials.size()) - 1).primitives.front());
    }
  }
  scene.meshes.push_back(std::move(room));
  scene.instances.push_back({.name = "room", .mesh = static_cast<int>(scene.meshes.size()) - 1});
}

inline PunctualLight point_light(const glm::vec3& candela, const glm::dvec3& position) {
  return {.name = "point", .intensity = candela, .position = position};
}

inline PunctualLight sun(const glm::vec3& lux, const glm::dvec3& direction) {
  return {.name = "sun",
          .kind = PunctualKind::kDirectional,
          .intensity = lux,
          .direction = glm::normalize(direction)};
}

inline CameraView look_at(const glm::dvec3& eye, const glm::dvec3& target, double yfov_rad = 0.8) {
  const glm::dvec3 z = glm::normalize(eye - target);
  const glm::dvec3 aside = std::abs(z.y) > 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 x = glm::normalize(glm::cross(aside, z));
  const glm::dvec3 y = glm::cross(z, x);
  CameraView view;
  view.to_world =
      glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(eye, 1.0));
  view.yfov_rad = yfov_rad;
  return view;
}

/// An orthographic camera that sees a square of half a side `half` around `target`.
inline CameraView close_up(const glm::dvec3& eye, const glm::dvec3& target, double half) {
  CameraView view = look_at(eye, target);
  view.orthographic = true;
  view.xmag = half;
  view.ymag = half;
  return view;
}

}  // namespace vitrine
