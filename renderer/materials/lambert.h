// Lambert's lobe: f = albedo / pi, sampled by the cosine.
#pragma once

#include "materials/lobe.h"
#include "sampling/warps.h"

namespace vitrine {

template <class N>
LobeValue<N> eval_lambert(const Vec3<typename N::Unit>& albedo, const Vec3<typename N::Unit>& wi) {
  const typename N::Density pdf_w = pdf_cosine_hemisphere<N>(wi.z);
  return {albedo, pdf_w, pdf_w};
}

template <class N>
Vec3<typename N::Unit> sample_lambert(typename N::Unit u, typename N::Unit v) {
  return sample_cosine_hemisphere<N>(u, v);
}

}  // namespace vitrine
