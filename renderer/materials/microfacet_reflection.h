// Reflection by rough GGX facets: f cos = F D G2 / (4 co), weighted by the given Fresnel term.
#pragma once

#include "materials/fresnel.h"
#include "materials/ggx.h"
#include "materials/lobe.h"

namespace vitrine {

/// `fresnel(cos)` gives the tint for the angle between wo and the facet. wo.z > 0, wi.z > 0.
template <class N, class Fresnel>
LobeValue<N> eval_microfacet_reflection(const Ggx<N>& ggx, const Vec3<typename N::Unit>& wo,
                                        const Vec3<typename N::Unit>& wi, const Fresnel& fresnel,
                                        DirectionSampling how = DirectionSampling::kBrdfCosine) {
  using Unit = typename N::Unit;
  using Density = typename N::Density;
  const Vec3<Unit> h = normalize(wo + wi);
  const Density half_d = ggx.d(h) * Density(0.5);
  const Unit smith_o = ggx.smith(wo.z);
  const Unit smith_i = ggx.smith(wi.z);
  const Unit cos_o = dot(wo, h);
  return {fresnel(cos_o), half_d * Density(wi.z) / Density(wo.z * smith_i + wi.z * smith_o),
          how == DirectionSampling::kBrdf ? half_d * Density(0.5) * Density(h.z) / Density(cos_o)
                                          : half_d / Density(wo.z + smith_o)};
}

/// The direction may lie below the surface: then it carries nothing.
template <class N>
Vec3<typename N::Unit> sample_microfacet_reflection(const Ggx<N>& ggx, const Vec3<typename N::Unit>& wo,
                                                    typename N::Unit u, typename N::Unit v,
                                                    DirectionSampling how = DirectionSampling::kBrdfCosine) {
  const Vec3<typename N::Unit> h = ggx.sample(wo, u, v, how);
  return reflect(wo, h, dot(wo, h));
}

}  // namespace vitrine
