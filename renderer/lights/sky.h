// The environment: a sky whose radiance blends from the horizon to the zenith by the height of the direction,
// over a uniform ground. Sampled uniformly over the sphere.
#pragma once

#include "lights/light_sample.h"
#include "sampling/warps.h"

namespace vitrine {

template <class N>
struct Sky {
  Vec3<typename N::Radiance> zenith;
  Vec3<typename N::Radiance> horizon;
  Vec3<typename N::Radiance> ground;

  [[nodiscard]] Vec3<typename N::Radiance> radiance(const Vec3<typename N::Unit>& direction) const {
    const typename N::Unit height = direction.y;
    if (height < 0) return ground;
    const typename N::Unit rest = height < 1 ? 1 - height : typename N::Unit(0);
    return horizon * rest + zenith * height;
  }
  [[nodiscard]] LightSample<N> sample(typename N::Unit u, typename N::Unit v) const {
    const Vec3<typename N::Unit> wi = sample_uniform_sphere<N>(u, v);
    return {.wi = wi, .end = std::nullopt, .radiance = radiance(wi), .pdf_w = pdf_w()};
  }
  [[nodiscard]] static typename N::Density pdf_w() { return pdf_uniform_sphere<N>(); }
};

}  // namespace vitrine
