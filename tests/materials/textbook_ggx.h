// The microfacet lobes in double precision as the papers print them (Walter et al. 2007, equations 20, 21,
// 33; Heitz 2014, equations 72, 99): tangents and Lambda, none of the rearrangements of the renderer.
#pragma once

#include <cmath>
#include <numbers>

#include <glm/glm.hpp>

namespace vitrine::textbook {

inline double squared_tangent(const glm::dvec3& w) { return (1.0 - w.z * w.z) / (w.z * w.z); }

/// Facets per solid angle.
inline double d(const glm::dvec3& h, double alpha) {
  if (h.z <= 0.0) return 0.0;
  const double tail = 1.0 + squared_tangent(h) / (alpha * alpha);
  return 1.0 / (std::numbers::pi * alpha * alpha * std::pow(h.z, 4) * tail * tail);
}
inline double lambda(const glm::dvec3& w, double alpha) {
  return 0.5 * (std::sqrt(1.0 + alpha * alpha * squared_tangent(w)) - 1.0);
}
inline double g2(const glm::dvec3& a, const glm::dvec3& b, double alpha) {
  return 1.0 / (1.0 + lambda(a, alpha) + lambda(b, alpha));
}
/// Density of the visible normals.
inline double visible_d(const glm::dvec3& h, const glm::dvec3& wo, double alpha) {
  return glm::dot(wo, h) * d(h, alpha) / (wo.z * (1.0 + lambda(wo, alpha)));
}

/// Fresnel's equations by Snell's law; eta = n_t / n_i.
inline double fresnel(double cos_i, double eta) {
  const double sin_t = std::sqrt(1.0 - cos_i * cos_i) / eta;
  if (sin_t >= 1.0) return 1.0;
  const double cos_t = std::sqrt(1.0 - sin_t * sin_t);
  const double s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
  const double p = (cos_t - eta * cos_i) / (cos_t + eta * cos_i);
  return 0.5 * (s * s + p * p);
}
inline double schlick(double f0, double f90, double cosine) {
  return f0 + (f90 - f0) * std::pow(1.0 - cosine, 5);
}

struct Lobe {
  double f_cos;
  double pdf_w;
};

/// Without its Fresnel term.
inline Lobe reflection(const glm::dvec3& wo, const glm::dvec3& wi, double alpha) {
  const glm::dvec3 h = glm::normalize(wo + wi);
  return {d(h, alpha) * g2(wo, wi, alpha) / (4.0 * wo.z), visible_d(h, wo, alpha) / (4.0 * glm::dot(wo, h))};
}

/// wo in the medium of index 1, wi in that of index eta; with its Fresnel term.
inline Lobe transmission(const glm::dvec3& wo, const glm::dvec3& wi, double eta, double alpha) {
  glm::dvec3 h = -glm::normalize(wi * eta + wo);
  if (h.z < 0.0) h = -h;
  const double cos_o = glm::dot(wo, h);
  const double cos_i = glm::dot(wi, h);
  if (cos_o <= 0.0 || cos_i >= 0.0) return {0.0, 0.0};
  const double denominator = std::pow(eta * cos_i + cos_o, 2);
  const double f = std::abs(cos_i * cos_o / (wi.z * wo.z)) * (1.0 - fresnel(cos_o, eta)) * g2(wo, wi, alpha) *
                   d(h, alpha) / denominator;
  return {f * std::abs(wi.z), visible_d(h, wo, alpha) * eta * eta * std::abs(cos_i) / denominator};
}

}  // namespace vitrine::textbook
