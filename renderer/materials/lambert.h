// Lambert's lobe: f = albedo / pi. Its BRDF is the same everywhere, times the cosine it is the cosine: so its
// four samplings are but two.
#pragma once

#include "materials/direction_sampling.h"
#include "materials/lobe.h"
#include "sampling/warps.h"

namespace vitrine {

constexpr bool is_uniform_for_lambert(DirectionSampling how) {
  return how == DirectionSampling::kUniform || how == DirectionSampling::kBrdf;
}

/// 1/sr, of a direction above the surface at this cosine.
template <class N>
typename N::Density pdf_lambert(typename N::Unit cosine, DirectionSampling how) {
  return is_uniform_for_lambert(how) ? pdf_uniform_hemisphere<N>() : pdf_cosine_hemisphere<N>(cosine);
}

template <class N>
LobeValue<N> eval_lambert(const Vec3<typename N::Unit>& albedo, const Vec3<typename N::Unit>& wi,
                          DirectionSampling how = DirectionSampling::kBrdfCosine) {
  const typename N::Density by_cosine = pdf_cosine_hemisphere<N>(wi.z);
  return {albedo, by_cosine, is_uniform_for_lambert(how) ? pdf_uniform_hemisphere<N>() : by_cosine};
}

template <class N>
Vec3<typename N::Unit> sample_lambert(typename N::Unit u, typename N::Unit v,
                                      DirectionSampling how = DirectionSampling::kBrdfCosine) {
  return is_uniform_for_lambert(how) ? sample_uniform_hemisphere<N>(u, v) : sample_cosine_hemisphere<N>(u, v);
}

}  // namespace vitrine
