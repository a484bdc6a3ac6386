// When a path ends. Russian roulette lets it go on with a probability and divides what it then finds by it,
// so the mean stays true whatever the probability; a fixed depth just cuts it off. Lecture: "Russian
// Roulette".
#pragma once

#include <algorithm>
#include <cstdint>

#include "numeric/vec.h"

namespace vitrine {

struct StoppingRule {
  enum class Kind : std::uint8_t {
    kThroughput,   ///< by what the path is still worth, after a few scattering events
    kReflectance,  ///< by what the surface reflects: darker patches shorten paths
    kConstant,     ///< always with the same probability
    kFixedDepth,   ///< after a number of scattering events: biased
  };
  Kind kind = Kind::kThroughput;
  int depth = 5;                           ///< kFixedDepth: scattering events of the longest path
  std::uint32_t alpha_bits = 0x80000000U;  ///< kConstant: the probability to go on, in units of 2^-32

  bool operator==(const StoppingRule&) const = default;
};

/// The rule in a number system.
template <class N>
class Roulette {
  using Unit = typename N::Unit;

 public:
  explicit Roulette(const StoppingRule& rule)
      : kind_(rule.kind), alpha_(N::unit_from_bits(rule.alpha_bits)) {}

  /// The probability that a path goes on which now has scattered `depth` times, from a surface of that
  /// `reflectance`, and has the throughput `beta`.
  [[nodiscard]] Unit prob(std::uint32_t depth, Unit reflectance, const Vec3<typename N::Weight>& beta) const {
    switch (kind_) {
      case StoppingRule::Kind::kThroughput:
        return depth < kFirstByThroughput ? Unit(1) : std::min(Unit(max_component(beta)), kMost);
      case StoppingRule::Kind::kReflectance:
        return std::min(reflectance, kMost);
      case StoppingRule::Kind::kConstant:
        return alpha_;
      case StoppingRule::Kind::kFixedDepth:
        break;
    }
    return Unit(1);
  }

 private:
  /// Short paths carry most of the light.
  static constexpr std::uint32_t kFirstByThroughput = 3;
  /// Or a path between mirrors would not end.
  static constexpr Unit kMost = Unit(0.95);

  StoppingRule::Kind kind_;
  Unit alpha_;
};

}  // namespace vitrine
