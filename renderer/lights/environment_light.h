// Light from infinitely far away in all directions: a sky in closed form or a picture, whichever the scene
// has.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "lights/environment_map.h"
#include "lights/sky.h"

namespace vitrine {

template <class N>
class EnvironmentLight {
  using Unit = typename N::Unit;

 public:
  EnvironmentLight(Sky<N> sky) : form_(std::move(sky)) {}             // NOLINT: it is one
  EnvironmentLight(EnvironmentMap<N> map) : form_(std::move(map)) {}  // NOLINT: it is one

  [[nodiscard]] Vec3<typename N::Radiance> radiance(const Vec3<Unit>& direction) const {
    return std::visit([&](const auto& form) { return form.radiance(direction); }, form_);
  }
  [[nodiscard]] std::optional<LightSample<N>> sample(std::uint32_t bits, Unit u, Unit v) const {
    return std::visit([&](const auto& form) { return form.sample(bits, u, v); }, form_);
  }
  /// The density with which sample() gives `direction`, 1/sr.
  [[nodiscard]] typename N::Density pdf_w(const Vec3<Unit>& direction) const {
    return std::visit([&](const auto& form) { return form.pdf_w(direction); }, form_);
  }

  /// Over all directions, in the radiance units of the world; of use while building.
  [[nodiscard]] double mean_luminance() const {
    return std::visit([](const auto& form) { return form.mean_luminance(); }, form_);
  }

 private:
  std::variant<Sky<N>, EnvironmentMap<N>> form_;
};

}  // namespace vitrine
