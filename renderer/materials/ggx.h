// The GGX distribution of microfacet normals (Walter et al. 2007) with Smith's masking, height-correlated
// (Heitz 2014); sampling of all normals, and of the visible ones by a spherical cap (Dupuy, Benyoub 2023).
//
//   D(h) = alpha^2 / (pi s^2),  s = h.x^2 + h.y^2 + alpha^2 h.z^2     (no cancellation at small alpha)
#pragma once

#include "materials/direction_sampling.h"
#include "numeric/trigonometry.h"
#include "numeric/vec.h"

namespace vitrine {

/// The alpha below which a lobe is taken for a delta distribution.
template <class N>
constexpr typename N::Unit smooth_below() {
  return typename N::Unit(0.001);
}

template <class N>
class Ggx {
  using Unit = typename N::Unit;
  using Density = typename N::Density;

 public:
  /// alpha = roughness^2, in [0.001, 1].
  explicit Ggx(Unit alpha) : alpha_(alpha), alpha2_(alpha * alpha), wide_alpha2_(Density(square(alpha))) {}

  /// Facets per solid angle, 1/sr.
  [[nodiscard]] Density d(const Vec3<Unit>& h) const {
    const Density s = Density(square(h.x) + square(h.y)) + wide_alpha2_ * Density(square(h.z));
    return wide_alpha2_ / (Density(3.141592653589793) * s * s);
  }
  /// sqrt(alpha^2 + (1 - alpha^2) cos^2), of which G1 and G2 are made:
  /// G1(o) = 2 co / (co + so),  G2 = 2 co ci / (co si + ci so).
  [[nodiscard]] Unit smith(Unit cosine) const { return sqrt(alpha2_ + (1 - alpha2_) * (cosine * cosine)); }

  /// A facet normal by the area that it shows to wo; density G1(o) D(h) (wo.h) / wo.z.
  [[nodiscard]] Vec3<Unit> sample_visible(const Vec3<Unit>& wo, Unit u, Unit v) const {
    const Vec3<Unit> w = normalize(Vec3<Unit>(alpha_ * wo.x, alpha_ * wo.y, wo.z));
    const auto [sine, cosine] = sincos_turns(u);
    const Unit z = 1 - v - v * w.z;
    const Unit r = sqrt(1 - z * z);
    const Unit x = r * cosine + w.x;
    const Unit y = r * sine + w.y;
    const Unit top = z + w.z;
    return normalize(Vec3<Unit>(alpha_ * x, alpha_ * y, top < 0 ? Unit(0) : top));
  }
  /// A facet normal by its area: density D(h) h.z. Its slope is alpha sqrt(v / (1 - v)).
  [[nodiscard]] Vec3<Unit> sample_any(Unit u, Unit v) const {
    const auto [sine, cosine] = sincos_turns(u);
    const Unit r = alpha_ * sqrt(v);
    return normalize(Vec3<Unit>(r * cosine, r * sine, sqrt(1 - v)));
  }
  /// By `how`: kBrdf takes any facet, otherwise one that wo sees.
  [[nodiscard]] Vec3<Unit> sample(const Vec3<Unit>& wo, Unit u, Unit v, DirectionSampling how) const {
    return how == DirectionSampling::kBrdf ? sample_any(u, v) : sample_visible(wo, u, v);
  }

 private:
  Unit alpha_;
  Unit alpha2_;
  Density wide_alpha2_;
};

}  // namespace vitrine
