// When to stop: a path goes on with a probability, and what it then finds is divided by it, so the mean stays
// true. Here the probability follows the throughput: dark paths end early. Lecture: "Russian Roulette".
#pragma once

#include <algorithm>

#include "numeric/vec.h"

namespace vitrine {

/// Scattering events before the first test: short paths carry most of the light.
inline constexpr int kFirstRoulette = 3;

/// The probability that a path of this throughput goes on.
template <class N>
typename N::Unit roulette_prob(const Vec3<typename N::Weight>& beta) {
  using Unit = typename N::Unit;
  return std::min(Unit(max_component(beta)), Unit(0.95));
}

}  // namespace vitrine
