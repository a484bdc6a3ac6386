// Strata: the unit square in 8 x 8 cells, which 64 samples visit once each. Every aligned 2, 4, 8, 16 or 32
// of them lie in as many equal parts of the square, so that a few samples are stratified too. Cook (1986,
// "Stochastic Sampling in Computer Graphics") puts a sample somewhere in its cell; a deterministic rule in
// the middle.
#pragma once

#include <cstdint>

#include "sampling/owen_scramble.h"

namespace vitrine {

inline constexpr std::uint32_t kStrata = 64;

/// The column (axis 0) or row (axis 1) of the cell that the i-th of 64 samples visits, in the order that the
/// two seeds give. Both must be well mixed.
constexpr std::uint32_t stratum(std::uint32_t i, std::uint32_t axis, std::uint32_t order_seed,
                                std::uint32_t cell_seed) {
  const std::uint32_t shuffled = owen_scramble(i, order_seed) % kStrata;
  const std::uint32_t halves =
      owen_scramble_reversed(shuffled, cell_seed) >> axis;  // left or right, up or down
  return (halves & 1U) << 2 | (halves >> 1 & 2U) | (halves >> 4 & 1U);
}

}  // namespace vitrine
