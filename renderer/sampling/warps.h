// Warps of two uniform numbers onto directions and triangles, each with its density. Directions are in a
// local frame whose z axis is the normal; densities are per solid angle (1/sr). Sources: Dutre, Global
// Illumination Compendium, items 34-35 (hemispheres); Turk 1990 (triangle).
#pragma once

#include "numeric/trigonometry.h"
#include "numeric/vec.h"

namespace vitrine {

template <class N>
typename N::Density pdf_uniform_hemisphere() {
  return typename N::Density(0.15915494309189535);  // 1 / (2 pi)
}
template <class N>
Vec3<typename N::Unit> sample_uniform_hemisphere(typename N::Unit u, typename N::Unit v) {
  using Unit = typename N::Unit;
  const auto [sine, cosine] = sincos_turns(u);
  const Unit z = 1 - v;  // in (0, 1]
  const Unit r = sqrt(v * (1 + z));
  return {r * cosine, r * sine, z};
}

template <class N>
typename N::Density pdf_uniform_sphere() {
  return typename N::Density(0.07957747154594767);  // 1 / (4 pi)
}
template <class N>
Vec3<typename N::Unit> sample_uniform_sphere(typename N::Unit u, typename N::Unit v) {
  using Unit = typename N::Unit;
  const auto [sine, cosine] = sincos_turns(u);
  const Unit z = 1 - (v + v);
  const Unit r = sqrt((v + v) * (1 + z));
  return {r * cosine, r * sine, z};
}

template <class N>
typename N::Density pdf_cosine_hemisphere(typename N::Unit cosine) {
  return typename N::Density(cosine * typename N::Unit(0.3183098861837907));  // cos / pi
}
template <class N>
Vec3<typename N::Unit> sample_cosine_hemisphere(typename N::Unit u, typename N::Unit v) {
  using Unit = typename N::Unit;
  const auto [sine, cosine] = sincos_turns(u);
  const Unit r = sqrt(v);
  return {r * cosine, r * sine, sqrt(1 - v)};
}

/// Barycentric weights of a triangle's second and third corner, uniform over its area.
template <class N>
Vec2<typename N::Unit> sample_triangle(typename N::Unit u, typename N::Unit v) {
  using Unit = typename N::Unit;
  const Unit s = sqrt(u);
  return {s * (1 - v), s * v};
}

}  // namespace vitrine
