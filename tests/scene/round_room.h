// A ball seen from within: a closed surface without corners.
#pragma once

#include <cmath>
#include <numbers>

#include "scene/made_scene.h"

namespace vitrine {

/// A flat-shaded ball of radius 1 around the origin, of rings x 2 rings quads, facing inwards.
inline void place_round_room(Scene& scene, unsigned rings, const Material& material) {
  Primitive primitive;
  for (unsigned ring = 0; ring <= rings; ++ring) {
    const double theta = std::numbers::pi * ring / rings;
    for (unsigned step = 0; step < 2 * rings; ++step) {
      const double phi = std::numbers::pi * step / rings;
      primitive.positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta),
                                       std::sin(theta) * std::sin(phi));
      if (ring == rings) continue;
      const unsigned a = ring * 2 * rings + step;
      const unsigned b = ring * 2 * rings + (step + 1) % (2 * rings);
      primitive.triangles.emplace_back(a, a + 2 * rings, b);
      primitive.triangles.emplace_back(b, a + 2 * rings, b + 2 * rings);
    }
  }
  primitive.material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(material);
  scene.meshes.push_back({.name = "ball", .primitives = {std::move(primitive)}});
  scene.instances.push_back({.name = "ball", .mesh = static_cast<int>(scene.meshes.size()) - 1});
}

}  // namespace vitrine
