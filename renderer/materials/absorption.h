// Light is absorbed on its way through a solid (Beer, Lambert; KHR_materials_volume):
//
//   T(d) = attenuationColor^(d / attenuationDistance) = e^(-a d)
#pragma once

#include "numeric/exponential.h"
#include "numeric/vec.h"

namespace vitrine {

template <class N>
struct Absorption {
  using Density = typename N::Density;

  Vec3<Density> coefficient = Vec3<Density>(0);  ///< a, 1 / baked length

  /// False: clear.
  explicit operator bool() const { return max_component(coefficient) > 0; }

  /// What is left of light after `distance`.
  [[nodiscard]] Vec3<Density> transmittance(typename N::Length distance) const {
    const Density d(distance);
    return {exp_negative(coefficient.x * d), exp_negative(coefficient.y * d),
            exp_negative(coefficient.z * d)};
  }
};

}  // namespace vitrine
