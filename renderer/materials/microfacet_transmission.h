// Refraction through rough GGX facets (Walter et al. 2007), as radiance sees it: scaled by 1 / eta^2, since
// radiance is compressed or spread as it changes the medium.
//
//   f cos = T D G2 |wi.h| (wo.h) / (co eta^2 q^2),   q = wi.h + wo.h / eta
#pragma once

#include <optional>

#include "materials/fresnel.h"
#include "materials/ggx.h"
#include "materials/lobe.h"

namespace vitrine {

/// wo.z > 0 > wi.z; eta = n_t / n_i, away from 1.
template <class N>
LobeValue<N> eval_microfacet_transmission(const Ggx<N>& ggx, const Vec3<typename N::Unit>& tint,
                                          typename N::Unit eta, const Vec3<typename N::Unit>& wo,
                                          const Vec3<typename N::Unit>& wi,
                                          DirectionSampling how = DirectionSampling::kBrdfCosine) {
  using Unit = typename N::Unit;
  using Density = typename N::Density;
  Vec3<Unit> h = normalize(wi * eta + wo);
  if (h.z < 0) h = -h;
  const Unit cos_o = dot(wo, h);
  const Unit cos_i = -dot(wi, h);
  if (!(cos_o > 0) || !(cos_i > 0)) return {tint, Density(0), Density(0)};
  const Density q(abs(cos_o / eta - cos_i));
  const Density facets = ggx.d(h) * Density(cos_o) * Density(cos_i) / (q * q) * Density(2);
  const Unit smith_o = ggx.smith(wo.z);
  const Unit smith_i = ggx.smith(wi.z);
  const Unit transmittance = 1 - fresnel_dielectric(cos_o, eta).reflectance;
  const Density masking = Density(-wi.z) / Density(wo.z * smith_i - wi.z * smith_o);
  return {tint * transmittance, facets * masking / Density(square(eta)),
          how == DirectionSampling::kBrdf ? facets * Density(0.5) * Density(h.z) / Density(cos_o)
                                          : facets / Density(wo.z + smith_o)};
}

/// Nothing under total reflection.
template <class N>
std::optional<Vec3<typename N::Unit>> sample_microfacet_transmission(
    const Ggx<N>& ggx, typename N::Unit eta, const Vec3<typename N::Unit>& wo, typename N::Unit u,
    typename N::Unit v, DirectionSampling how = DirectionSampling::kBrdfCosine) {
  using Unit = typename N::Unit;
  const Vec3<Unit> h = ggx.sample(wo, u, v, how);
  const Unit cos_o = dot(wo, h);
  if (!(cos_o > 0)) return std::nullopt;
  const Unit cos_t = fresnel_dielectric(cos_o, eta).cos_t;
  if (!(cos_t > 0)) return std::nullopt;
  return refract(wo, h, cos_o, cos_t, eta);
}

}  // namespace vitrine
