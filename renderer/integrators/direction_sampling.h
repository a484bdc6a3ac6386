// The next direction of a path: uniform over the hemisphere, or by importance of BSDF times cosine. Delta
// lobes can only be met by sampling them, so both do. Lecture: "Indirect Illumination - Uniform Dist.", "-
// BRDF*Cosine Dist."
#pragma once

#include <optional>

#include "integrators/modes.h"
#include "materials/bsdf.h"
#include "sampling/warps.h"

namespace vitrine {

template <class N>
std::optional<BsdfSample<N>> sample_uniform_direction(const Bsdf<N>& bsdf, typename N::Unit choice,
                                                      typename N::Unit u, typename N::Unit v) {
  using Unit = typename N::Unit;
  using Density = typename N::Density;
  const Unit prob_delta = bsdf.prob_delta();
  if (choice < prob_delta) return bsdf.sample_delta(choice);
  if (!bsdf.is_rough()) return std::nullopt;
  const bool both = bsdf.is_rough_both_sides();
  const Vec3<Unit> wi = both ? sample_uniform_sphere<N>(u, v) : sample_uniform_hemisphere<N>(u, v);
  const Density pdf_w =
      (both ? pdf_uniform_sphere<N>() : pdf_uniform_hemisphere<N>()) * Density(1 - prob_delta);
  return BsdfSample<N>{wi, bsdf.eval(wi).f_cos / pdf_w, pdf_w, false};
}

template <class N>
std::optional<BsdfSample<N>> sample_direction(DirectionSampling how, const Bsdf<N>& bsdf,
                                              typename N::Unit choice, typename N::Unit u,
                                              typename N::Unit v) {
  return how == DirectionSampling::kUniform ? sample_uniform_direction(bsdf, choice, u, v)
                                            : bsdf.sample(choice, u, v);
}

}  // namespace vitrine
