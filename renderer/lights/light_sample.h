// A sampled direction to a light, as next event estimation uses it.
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/ray.h"

namespace vitrine {

template <class N>
struct LightSample {
  Vec3<typename N::Unit> wi;  ///< towards the light
  /// Where a shadow ray ends: the sampled point, off the light's surface. Nothing: infinitely far along wi.
  std::optional<Vec3<typename N::Length>> end;
  /// What arrives if nothing is in the way; irradiance of a delta light. A mesh light leaves it to the
  /// material of `triangle`.
  Vec3<typename N::Radiance> radiance;
  typename N::Density pdf_w;  ///< 1/sr; 1 for a delta light
  bool delta = false;         ///< no scattered ray could have found it
  std::uint32_t triangle = kNoTriangle;
  Vec2<typename N::Unit> barycentric{};  ///< of the sampled point in `triangle`
};

}  // namespace vitrine
