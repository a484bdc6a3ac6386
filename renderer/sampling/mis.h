// Multiple importance sampling of two strategies (Veach 1997, sections 9.2.2 and 9.2.3): what a sample of the
// strategy with density `a` counts where the other has density `b`. Densities are those of all samples that a
// strategy takes: their number times their density.
#pragma once

#include <cstdint>

namespace vitrine {

enum class MisHeuristic : std::uint8_t {
  kBalance,  ///< a / (a + b)
  kPower,    ///< a^2 / (a^2 + b^2)
};

/// The ratio is formed first: squared densities overflow.
template <class N>
typename N::Unit mis_weight(MisHeuristic heuristic, typename N::Density a, typename N::Density b) {
  using Density = typename N::Density;
  const Density ratio = b / a;
  const Density other = heuristic == MisHeuristic::kPower ? ratio * ratio : ratio;
  return typename N::Unit(Density(1) / (Density(1) + other));
}

}  // namespace vitrine
