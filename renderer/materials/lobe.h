// What every lobe of a BSDF says of a pair of directions. Directions are local: z is the shading normal, wo.z
// > 0. f times cosine is kept as tint times scale, so that all arithmetic of wide range is scalar.
#pragma once

#include "numeric/vec.h"

namespace vitrine {

template <class N>
struct LobeValue {
  Vec3<typename N::Unit> tint;
  typename N::Density scale;  ///< tint * scale = f * |cos wi|, 1/sr
  typename N::Density pdf_w;  ///< of the lobe's own sampling, 1/sr
};

}  // namespace vitrine
