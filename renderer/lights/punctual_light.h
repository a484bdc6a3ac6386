// Lights without extent, as KHR_lights_punctual defines them. Point: I / d^2. Spot: the same times a smooth
// falloff between the inner and the outer cone, clamp((cos - cos_outer) / (cos_inner - cos_outer))^2.
// Directional: lux.
#pragma once

#include <optional>

#include "lights/light_sample.h"

namespace vitrine {

template <class N>
struct PointLight {
  Vec3<typename N::Length> position;
  Vec3<typename N::Radiance> intensity;  ///< candela in baked lengths
  bool spot = false;
  Vec3<typename N::Unit> axis{};  ///< of a spot, the way it shines
  typename N::Unit cos_outer{};
  typename N::Density cone_scale{};  ///< 1 / (cos_inner - cos_outer)

  [[nodiscard]] std::optional<LightSample<N>> sample(const Vec3<typename N::Length>& p) const {
    using Unit = typename N::Unit;
    using Density = typename N::Density;
    const Vec3<typename N::Length> to_light = position - p;
    const typename N::Length distance = length(to_light);
    if (!(distance > 0)) return std::nullopt;
    const Vec3<Unit> wi = normalize(to_light);
    Density falloff = Density(1) / Density(distance * distance);
    if (spot) {
      const Unit inside = -dot(wi, axis) - cos_outer;
      if (!(inside > 0)) return std::nullopt;
      const Density ramp = Density(inside) * cone_scale;
      if (ramp < Density(1)) falloff = falloff * ramp * ramp;
    }
    return LightSample<N>{
        .wi = wi, .end = position, .radiance = intensity * falloff, .pdf_w = Density(1), .delta = true};
  }
};

template <class N>
struct DirectionalLight {
  Vec3<typename N::Unit> wi;              ///< towards the light
  Vec3<typename N::Radiance> irradiance;  ///< on a surface that faces it

  [[nodiscard]] LightSample<N> sample() const {
    return {.wi = wi,
            .end = std::nullopt,
            .radiance = irradiance,
            .pdf_w = typename N::Density(1),
            .delta = true};
  }
};

}  // namespace vitrine
