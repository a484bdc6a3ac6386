// One light at random, in proportion to its power: what one would give every receiver if it knew nothing of
// them. Lecture: "Direct Illumination - Many Lights", "would like to weight more brighter lights".
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "lights/light_emission.h"
#include "sampling/discrete_distribution.h"

namespace vitrine {

template <class N>
class PowerLightSelection {
 public:
  PowerLightSelection() = default;
  /// At least one light.
  explicit PowerLightSelection(std::span<const LightEmission> lights) {
    std::vector<double> powers;
    double total = 0.0;
    for (const LightEmission& light : lights) {
      powers.push_back(light.power);
      total += light.power;
    }
    // The weakest light may be the only one that reaches a corner, so none is left out.
    const double least = total > 0.0 ? total / static_cast<double>(lights.size()) * kLeast : 1.0;
    for (double& power : powers) power = std::max(power, least);
    chosen_ = DiscreteDistribution<N>(powers);
  }

  [[nodiscard]] std::uint32_t sample(std::uint32_t bits) const { return chosen_.sample(bits); }
  [[nodiscard]] typename N::Density prob(std::uint32_t light) const { return chosen_.prob(light); }

 private:
  static constexpr double kLeast = 1.0 / 4096.0;  // of what the light would get if all were alike

  DiscreteDistribution<N> chosen_;
};

}  // namespace vitrine
