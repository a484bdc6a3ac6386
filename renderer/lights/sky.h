// The environment: a sky whose radiance blends from the horizon to the zenith by the height of the direction,
// over a uniform ground. Its three parts are sampled in proportion to their power, each exactly as it shines:
//
//   part     radiance         pdf_w            height h, from a number v
//   ground   G                1 / (2 pi)       -v            (any height below is as likely: Archimedes)
//   horizon  H (1 - h)        (1 - h) / pi     1 - sqrt(v)
//   zenith   Z h              h / pi           sqrt(v)
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "lights/light_sample.h"
#include "numeric/color.h"
#include "numeric/host_conversion.h"
#include "numeric/trigonometry.h"
#include "sampling/discrete_distribution.h"

namespace vitrine {

template <class N>
class Sky {
  using Unit = typename N::Unit;
  using Density = typename N::Density;
  using Radiance = typename N::Radiance;

 public:
  Sky(const Vec3<Radiance>& zenith, const Vec3<Radiance>& horizon, const Vec3<Radiance>& ground)
      : zenith_(zenith), horizon_(horizon), ground_(ground) {
    const auto brightness = [](const Vec3<Radiance>& c) { return luminance<double>(to_host(c)); };
    std::array<double, 3> powers{2.0 * brightness(ground), brightness(horizon), brightness(zenith)};
    mean_luminance_ = (powers[0] + powers[1] + powers[2]) / 4.0;
    if (!(mean_luminance_ > 0.0)) powers = {2.0, 1.0, 1.0};  // black: any will do
    part_ = DiscreteDistribution<N>(powers);
  }

  [[nodiscard]] Vec3<Radiance> radiance(const Vec3<Unit>& direction) const {
    if (direction.y < 0) return ground_;
    return horizon_ * from_zenith(direction) + zenith_ * direction.y;
  }
  /// Nothing where rounding led to a direction without light.
  [[nodiscard]] std::optional<LightSample<N>> sample(std::uint32_t bits, Unit u, Unit v) const {
    const auto [sine, cosine] = sincos_turns(u);
    const std::uint32_t part = part_.sample(bits);
    const Unit root = sqrt(v);
    const Unit height = part == kGround ? -v : (part == kHorizon ? 1 - root : root);
    const Unit r = sqrt((1 - height) * (1 + height));
    const Vec3<Unit> wi(r * cosine, height, r * sine);
    const Density pdf_w = this->pdf_w(wi);
    if (!(pdf_w > 0)) return std::nullopt;
    return LightSample<N>{.wi = wi, .end = std::nullopt, .radiance = radiance(wi), .pdf_w = pdf_w};
  }
  [[nodiscard]] Density pdf_w(const Vec3<Unit>& direction) const {
    if (direction.y < 0) return part_.prob(kGround) * Density(0.15915494309189535);  // 1 / (2 pi)
    return (part_.prob(kHorizon) * Density(from_zenith(direction)) +
            part_.prob(kZenith) * Density(direction.y)) *
           Density(0.3183098861837907);  // 1 / pi
  }

  /// Over all directions; of use while building.
  [[nodiscard]] double mean_luminance() const { return mean_luminance_; }

 private:
  static constexpr std::uint32_t kGround = 0;
  static constexpr std::uint32_t kHorizon = 1;
  static constexpr std::uint32_t kZenith = 2;

  static Unit from_zenith(const Vec3<Unit>& direction) {  // a direction may be a little too long
    return direction.y < 1 ? 1 - direction.y : Unit(0);
  }

  Vec3<Radiance> zenith_;
  Vec3<Radiance> horizon_;
  Vec3<Radiance> ground_;
  DiscreteDistribution<N> part_;
  double mean_luminance_ = 0.0;
};

}  // namespace vitrine
