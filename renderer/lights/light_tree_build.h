// Builds the tree of lights on the host's arithmetic: near and far lights apart, and near ones split where
// the surface area orientation heuristic is least (Conty Estevez and Kulla 2018, section 4.4):
//
//   cost = intensity * M_area * M_omega of either side, times the longest side of the bounds over that which
//   is split; M_omega is the solid angle into which the side shines, weighted by the cosine at its rim
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lights/light_emission.h"

namespace vitrine {

/// A light or several, as one.
struct LightCluster {
  LightEmission emission;   ///< without power
  std::uint32_t first = 0;  ///< the light, or the first of two children; the second follows it
  std::uint32_t count = 0;  ///< of lights; 1: a light itself
};

struct LightTreeLayout {
  std::vector<LightCluster> nodes;  ///< the root first; empty without lights
  /// Of each light the way from the root: bit i tells whether step i leads to the second child.
  std::vector<std::uint64_t> trails;
};

/// Leads to every light within 63 steps, for less than 2^32 lights.
LightTreeLayout build_light_tree(std::span<const LightEmission> lights);

}  // namespace vitrine
