// How much of a surface is there: glTF's alphaMode. Coverage a lets a ray go on with probability 1 - a
// (stochastic transparency, Enderton et al. 2010), so that no estimator needs to know of it.
#pragma once

#include <optional>

#include "materials/texture.h"
#include "scene/surface_coordinates.h"

namespace vitrine {

template <class N>
struct Coverage {
  using Unit = typename N::Unit;

  bool complete = true;  ///< 1 everywhere; the rest does not matter
  Unit alpha{};
  std::optional<Unit> cutoff;  ///< all or nothing, by whether alpha reaches it
  std::optional<Texture<N>> texture;

  /// The coverage at a point of a surface that is not complete.
  [[nodiscard]] Unit share(const SurfaceCoordinates<N>& at, const TexelTable<N>& linear) const {
    Unit a = alpha * at.alpha;
    if (texture) a *= texture->sample_alpha(at.uv(texture->uv_set), linear);
    if (!cutoff) return a;
    return a < *cutoff ? Unit(0) : Unit(1);
  }
};

}  // namespace vitrine
