// An axis-aligned box on the host's arithmetic, for building and for framing.
#pragma once

#include <limits>

#include <glm/glm.hpp>

namespace vitrine {

/// Empty until it grows.
struct Bounds {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  void grow(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void grow(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  /// Half the surface area; 0 for empty bounds.
  [[nodiscard]] double half_area() const {
    const glm::dvec3 d = glm::max(high - low, glm::dvec3(0.0));
    return d.x * d.y + d.y * d.z + d.z * d.x;
  }
};

}  // namespace vitrine
