// Which light to ask: every way to choose one, behind one interface. Lecture: "Direct Illumination - Many
// Lights".
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "lights/light_tree.h"
#include "lights/power_light_selection.h"
#include "lights/receiver.h"
#include "lights/uniform_light_selection.h"

namespace vitrine {

enum class LightSelection : std::uint8_t {
  kUniform,  ///< one at random, each as likely as the others
  kAll,      ///< the samples are split over all lights: none is chosen
  kPower,    ///< one in proportion to its power
  kTree,     ///< one by a light tree: by its power, orientation and distance as the receiver sees them
};

template <class N>
class LightSelectors {
  using Density = typename N::Density;

 public:
  LightSelectors() = default;
  explicit LightSelectors(std::span<const LightEmission> lights)
      : count_(static_cast<std::uint32_t>(lights.size())), uniform_(count_), tree_(lights) {
    if (count_ > 0) power_ = PowerLightSelection<N>(lights);
  }

  /// A light for 32 random bits, or nothing where no light can count. Not for kAll.
  [[nodiscard]] std::optional<SelectedLight<N>> select(LightSelection how, const Receiver<N>& receiver,
                                                       std::uint32_t bits) const {
    if (count_ == 0) return std::nullopt;
    if (how == LightSelection::kTree) return tree_.select(receiver, bits);
    const std::uint32_t light = how == LightSelection::kPower ? power_.sample(bits) : uniform_.sample(bits);
    return SelectedLight<N>{light, prob(how, receiver, light)};
  }
  /// The probability with which select() gives `light`; 1 for kAll.
  [[nodiscard]] Density prob(LightSelection how, const Receiver<N>& receiver, std::uint32_t light) const {
    switch (how) {
      case LightSelection::kUniform:
        return uniform_.prob(light);
      case LightSelection::kPower:
        return power_.prob(light);
      case LightSelection::kTree:
        return tree_.prob(receiver, light);
      case LightSelection::kAll:
        break;
    }
    return Density(1);
  }

 private:
  std::uint32_t count_ = 0;
  UniformLightSelection<N> uniform_;
  PowerLightSelection<N> power_;
  LightTree<N> tree_;
};

}  // namespace vitrine
