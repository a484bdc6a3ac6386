// A clear coat over everything else: KHR_materials_clearcoat, GGX facets of a varnish of index 1.5. The
// extension takes from the base what the coat reflects towards the viewer; here it is what the coat reflects
// towards the viewer or the light, whichever is more, so that light may go either way.
//
//   f = w F(wo.h) D G2 / (4 co ci) + (1 - w F(min(co, ci))) f_base,     F = 0.04 + 0.96 (1 - cos)^5
#pragma once

#include <algorithm>

#include "materials/fresnel.h"
#include "materials/microfacet_reflection.h"

namespace vitrine {

template <class N>
struct Clearcoat {
  using Unit = typename N::Unit;
  Unit weight = Unit(0);  ///< how much of the surface it covers; 0: none
  Unit alpha = Unit(1);   ///< GGX width
  bool smooth = false;    ///< a delta lobe rather than GGX

  /// What it reflects of light at this cosine; its colour is white.
  [[nodiscard]] Unit reflectance(Unit cosine) const {
    const Unit c = std::min(std::max(cosine, Unit(0)), Unit(1));
    return weight * fresnel_schlick(Vec3<Unit>(Unit(0.04)), Unit(1), c).x;
  }
  /// What it leaves to the layers below.
  [[nodiscard]] Unit left_over(Unit cos_o, Unit cos_i) const {
    return 1 - reflectance(std::min(cos_o, cos_i));
  }
};

/// wo.z > 0, wi.z > 0.
template <class N>
LobeValue<N> eval_clearcoat(const Clearcoat<N>& coat, const Vec3<typename N::Unit>& wo,
                            const Vec3<typename N::Unit>& wi,
                            DirectionSampling how = DirectionSampling::kBrdfCosine) {
  using Unit = typename N::Unit;
  return eval_microfacet_reflection(
      Ggx<N>(coat.alpha), wo, wi, [&](Unit cosine) { return Vec3<Unit>(coat.reflectance(cosine)); }, how);
}

/// The direction may lie below the surface: then it carries nothing.
template <class N>
Vec3<typename N::Unit> sample_clearcoat(const Clearcoat<N>& coat, const Vec3<typename N::Unit>& wo,
                                        typename N::Unit u, typename N::Unit v,
                                        DirectionSampling how = DirectionSampling::kBrdfCosine) {
  return sample_microfacet_reflection(Ggx<N>(coat.alpha), wo, u, v, how);
}

}  // namespace vitrine
