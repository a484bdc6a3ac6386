// How much light a surface reflects by angle: exactly for dielectrics, after Schlick (1994) where glTF says
// so.
#pragma once

#include "numeric/vec.h"

namespace vitrine {

/// Schlick's approximation: `f0` at normal incidence, `f90` at grazing. cosine in [0, 1].
template <class Unit>
constexpr Vec3<Unit> fresnel_schlick(const Vec3<Unit>& f0, Unit f90, Unit cosine) {
  const Unit x = 1 - cosine;
  const Unit x2 = x * x;
  return f0 + (Vec3<Unit>(f90) - f0) * (x2 * x2 * x);
}

template <class Unit>
struct DielectricFresnel {
  Unit reflectance;
  Unit cos_t;  ///< of the refracted direction, 0 under total reflection
};

/// Fresnel's equations for unpolarised light. eta = n_t / n_i in [1/2.9, 2.9], cos_i in [0, 1].
template <class Unit>
constexpr DielectricFresnel<Unit> fresnel_dielectric(Unit cos_i, Unit eta) {
  const Unit sin_t = sqrt(1 - cos_i * cos_i) / eta;
  if (!(sin_t < 1)) return {Unit(1), Unit(0)};
  const Unit cos_t = sqrt(1 - sin_t * sin_t);
  const Unit parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  const Unit perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
  return {Unit(0.5) * (parallel * parallel + perpendicular * perpendicular), cos_t};
}

/// wo mirrored about h; both on h's side.
template <class Unit>
constexpr Vec3<Unit> reflect(const Vec3<Unit>& wo, const Vec3<Unit>& h, Unit cos_o) {
  return h * (cos_o + cos_o) - wo;
}

/// wo refracted through the facet h on wo's side: Snell's law, with cos_t from fresnel_dielectric().
template <class Unit>
constexpr Vec3<Unit> refract(const Vec3<Unit>& wo, const Vec3<Unit>& h, Unit cos_o, Unit cos_t, Unit eta) {
  return normalize(h * (cos_o / eta - cos_t) - wo * (Unit(1) / eta));
}

}  // namespace vitrine
