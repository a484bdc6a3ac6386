// Charlie, the sheen of cloth, in double precision as KHR_materials_sheen prints it.
#pragma once

#include <cmath>
#include <numbers>

#include <glm/glm.hpp>

namespace vitrine::textbook {

inline double charlie_l(double x, double alpha) {
  const double t = (1.0 - alpha) * (1.0 - alpha);
  const double a = std::lerp(21.5473, 25.3245, t);
  const double b = std::lerp(3.82987, 3.32435, t);
  const double c = std::lerp(0.19823, 0.16801, t);
  const double d = std::lerp(-1.97760, -1.27393, t);
  const double e = std::lerp(-4.32054, -4.85967, t);
  return a / (1.0 + b * std::pow(x, c)) + d * x + e;
}
inline double charlie_lambda(double cosine, double alpha) {
  return cosine < 0.5 ? std::exp(charlie_l(cosine, alpha))
                      : std::exp(2.0 * charlie_l(0.5, alpha) - charlie_l(1.0 - cosine, alpha));
}
inline double charlie_d(const glm::dvec3& h, double alpha) {
  return (2.0 + 1.0 / alpha) * std::pow(1.0 - h.z * h.z, 0.5 / alpha) / (2.0 * std::numbers::pi);
}
/// f * cos of a white sheen; alpha = roughness^2.
inline double sheen_f_cos(const glm::dvec3& wo, const glm::dvec3& wi, double alpha) {
  const double g = 1.0 / (1.0 + charlie_lambda(wo.z, alpha) + charlie_lambda(wi.z, alpha));
  return charlie_d(glm::normalize(wo + wi), alpha) * g / (4.0 * wo.z);
}

}  // namespace vitrine::textbook
