// The sheen of cloth: KHR_materials_sheen, upright fibres that scatter light at grazing angles (Conty
// Estevez, Kulla 2017, "Production Friendly Microfacet Sheen BRDF"). Their fit of the shadowing:
//
//   f = D / (4 co ci (1 + lambda(co) + lambda(ci))),   D(h) = (2 + 1/alpha) sin(h)^(1/alpha) / (2 pi)
//   lambda(x) = exp l(x) below 1/2, exp(2 l(1/2) - l(1 - x)) above,   l(x) = a / (1 + b x^c) - d x - e
//
// As the paper does, it is sampled uniformly: it has no peak, but a wide rim.
#pragma once

#include <algorithm>

#include "materials/lobe.h"
#include "numeric/exponential.h"
#include "sampling/warps.h"

namespace vitrine {

/// Fibres of one roughness.
template <class N>
class Charlie {
  using Unit = typename N::Unit;
  using Density = typename N::Density;

 public:
  /// The sharpest rim: below it, one would have to look along the surface to see any.
  static constexpr Unit least_roughness() { return Unit(0.1); }

  /// alpha = roughness^2, roughness in [0, 1].
  explicit Charlie(Unit roughness) {
    const Unit r = std::max(roughness, least_roughness());
    const Unit alpha = r * r;
    const Density inverse = Density(1) / Density(alpha);
    half_inverse_ = inverse * Density(0.5);
    norm_ = (Density(2) + inverse) * Density(0.15915494309189535);
    const Density sharp((1 - alpha) * (1 - alpha));
    const Density blunt(1 - (1 - alpha) * (1 - alpha));
    a_ = Density(21.5473) + Density(3.7772) * sharp;
    b_ = Density(3.32435) + Density(0.50552) * blunt;
    c_ = Density(0.16801) + Density(0.03022) * blunt;
    d_ = Density(1.27393) + Density(0.70367) * blunt;
    e_ = Density(4.32054) + Density(0.53913) * sharp;
  }

  /// Fibres per solid angle, 1/sr.
  [[nodiscard]] Density d(const Vec3<Unit>& h) const {
    return norm_ * pow(std::min(h.x * h.x + h.y * h.y, Unit(1)), half_inverse_);
  }
  /// Smith's lambda for a direction at this cosine.
  [[nodiscard]] Density lambda(Unit cosine) const {
    constexpr Unit kHalf(0.5);
    if (cosine < kHalf) return exp_negative(falling(cosine)) / exp_negative(rising(cosine));
    const Unit rest = std::max(1 - cosine, Unit(0));
    return exp_negative(falling(kHalf) + falling(kHalf) + rising(rest)) /
           exp_negative(rising(kHalf) + rising(kHalf) + falling(rest));
  }

 private:
  // l(x) = rising(x) - falling(x), of which Densities can only hold the parts.
  [[nodiscard]] Density rising(Unit x) const { return a_ / (Density(1) + b_ * pow(x, c_)); }
  [[nodiscard]] Density falling(Unit x) const { return d_ * Density(x) + e_; }

  Density half_inverse_;
  Density norm_;
  Density a_;
  Density b_;
  Density c_;
  Density d_;
  Density e_;
};

/// wo.z > 0, wi.z > 0.
template <class N>
LobeValue<N> eval_sheen(const Charlie<N>& charlie, const Vec3<typename N::Unit>& color,
                        const Vec3<typename N::Unit>& wo, const Vec3<typename N::Unit>& wi) {
  using Density = typename N::Density;
  const Density shadowing = Density(1) + charlie.lambda(wo.z) + charlie.lambda(wi.z);
  return {color, charlie.d(normalize(wo + wi)) / (Density(4) * Density(wo.z) * shadowing),
          pdf_uniform_hemisphere<N>()};
}

template <class N>
Vec3<typename N::Unit> sample_sheen(typename N::Unit u, typename N::Unit v) {
  return sample_uniform_hemisphere<N>(u, v);
}

}  // namespace vitrine
