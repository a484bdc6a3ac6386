// One light at random, each as likely as the others. Lecture: "PT Pseudocode - Direct Illumination", pick
// random light.
#pragma once

#include <cstdint>

#include "numeric/host_conversion.h"

namespace vitrine {

template <class N>
class UniformLightSelection {
 public:
  UniformLightSelection() = default;
  explicit UniformLightSelection(std::uint32_t count)
      : count_(count), prob_(from_host<typename N::Density>(count == 0 ? 0.0 : 1.0 / count)) {}

  [[nodiscard]] std::uint32_t sample(std::uint32_t bits) const {
    return static_cast<std::uint32_t>((std::uint64_t{bits} * count_) >> 32);
  }
  [[nodiscard]] typename N::Density prob(std::uint32_t /*light*/) const { return prob_; }

 private:
  std::uint32_t count_ = 0;
  typename N::Density prob_{};
};

}  // namespace vitrine
