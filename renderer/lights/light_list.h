// All lights of a world under one index: meshes first, then points and spots, then directional ones, the sky
// last.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lights/environment_light.h"
#include "lights/light_points.h"
#include "lights/mesh_light.h"
#include "lights/punctual_light.h"

namespace vitrine {

template <class N>
struct LightList {
  std::vector<MeshLight<N>> meshes;
  std::vector<PointLight<N>> points;
  std::vector<DirectionalLight<N>> directional;
  std::optional<EnvironmentLight<N>> sky;

  [[nodiscard]] std::uint32_t size() const {
    return static_cast<std::uint32_t>(meshes.size() + points.size() + directional.size() + (sky ? 1U : 0U));
  }
  [[nodiscard]] std::uint32_t sky_index() const { return size() - 1; }

  /// Light `i` as seen from `p`, by three random numbers.
  [[nodiscard]] std::optional<LightSample<N>> sample(std::uint32_t i, LightPoints points_how,
                                                     const Vec3<typename N::Length>& p, std::uint32_t bits,
                                                     typename N::Unit u, typename N::Unit v) const {
    if (i < meshes.size()) return meshes[i].sample(points_how, p, bits, u, v);
    i -= static_cast<std::uint32_t>(meshes.size());
    if (i < points.size()) return points[i].sample(p);
    i -= static_cast<std::uint32_t>(points.size());
    if (i < directional.size()) return directional[i].sample();
    return sky->sample(bits, u, v);
  }
};

}  // namespace vitrine
