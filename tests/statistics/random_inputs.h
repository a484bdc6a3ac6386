// Random numbers to test with, of a generator that is not the renderer's own; the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include <glm/glm.hpp>

namespace vitrine {

class RandomInputs {
 public:
  explicit RandomInputs(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t bits() { return engine_(); }
  /// In [0, count).
  std::uint32_t index(std::size_t count) { return static_cast<std::uint32_t>(engine_() % count); }
  double uniform(double low = 0.0, double high = 1.0) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  /// Equally likely in every octave between `low` and `high`.
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  glm::dvec3 in_cube(double half_extent = 1.0) {
    const double x = uniform(-half_extent, half_extent);
    const double y = uniform(-half_extent, half_extent);
    const double z = uniform(-half_extent, half_extent);
    return {x, y, z};
  }
  /// Uniform on the unit sphere.
  glm::dvec3 direction() { return upwards(-1.0); }
  /// Uniform on the part of the unit sphere where z is at least this.
  glm::dvec3 upwards(double least_cosine) {
    const double z = uniform(least_cosine, 1.0);
    const double phi = uniform(0.0, 2.0 * std::numbers::pi);
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace vitrine
