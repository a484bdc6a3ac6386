// Multiple importance sampling of two strategies (Veach 1997, section 9.2).
#pragma once

namespace vitrine {

/// The power heuristic (exponent 2) for a sample of the strategy with density `a` where the other has density
/// `b`: a^2 / (a^2 + b^2). The ratio is formed first: squared densities overflow.
template <class N>
typename N::Unit power_heuristic(typename N::Density a, typename N::Density b) {
  using Density = typename N::Density;
  const Density ratio = b / a;
  return typename N::Unit(Density(1) / (Density(1) + ratio * ratio));
}

}  // namespace vitrine
