// Points whose error is blue noise on the screen: those of all samples of a square of 4^k pixels are a net
// together, so that of what one pixel gets too much its neighbours get too little. Ahmed and Wonka (2020,
// "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via Hierarchical Ordering of Pixels") give
// the pixels in Z order consecutive blocks of one Sobol sequence, of as many points as a pixel will have
// samples. Here that number is not known. Instead the place in Z order is a coordinate, the first of the
// (0,3)-sequence in base 4 that P^0, P^w and P^(w+1) make (see sobol.h): the net is there at every power of 4
// of samples.
//
// An index whose coordinate P^0 begins with the 16 digits of pixel m is m below the digits of a sample s. Of
// P^a times that the first 16 digits are P^a (a^16 s + m), as binom(16 + j, i) is binom(j, i), and a^16 = a.
#pragma once

#include <bit>
#include <cstdint>

#include "sampling/owen_scramble.h"
#include "sampling/sobol.h"

namespace vitrine {

/// Which pixel it is, as 16 digits in base 4, the first in the lowest bits: in which quarter of the screen of
/// 65536 x 65536 pixels it lies, in which quarter of that, and so on. Whether x or y is a digit's first bit
/// is a coin's toss for each square: neither is favoured. The seed must be well mixed.
constexpr std::uint32_t z_order(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  constexpr std::uint32_t kFirst = 0x55555555U;
  const auto spread = [](std::uint32_t bits) {
    bits = bits & 0x0000ffffU;
    bits = (bits | bits << 8) & 0x00ff00ffU;
    bits = (bits | bits << 4) & 0x0f0f0f0fU;
    bits = (bits | bits << 2) & 0x33333333U;
    return (bits | bits << 1) & kFirst;
  };
  const std::uint32_t order = reverse_bits(spread(y) << 1 | spread(x));
  const std::uint32_t coins = order ^ owen_scramble_reversed(order, seed);  // each depends on bits below it
  const std::uint32_t swap = (order ^ order >> 1) & coins & kFirst;
  return order ^ (swap | swap << 1);
}

/// Coordinate 0, 1, 2 or 3 of a pixel's sample, its first binary digit in the lowest bit. Within a pixel the
/// points are nets as those of sobol.h. Coordinates (0,1), and (2,3), are blue noise over the pixels in the
/// order that is passed to them; the two orders should be scrambled differently.
constexpr std::uint32_t screen_sobol(std::uint32_t z_order, std::uint32_t sample, std::uint32_t coordinate) {
  if (coordinate >= 2) sample = pascal_w(sample);
  if (coordinate % 2 == 0) return pascal_w(times_w(sample) ^ z_order);
  return pascal(pascal_w(times_w2(sample) ^ z_order));
}

/// Another order of the samples, for this pixel only: the first 1, 2, 4, 8 ... stay the first.
constexpr std::uint32_t reorder_within_octaves(std::uint32_t sample, std::uint32_t seed) {
  const std::uint32_t below_first_bit = std::bit_floor(sample | 1U) - 1;
  return (sample & ~below_first_bit) | (owen_scramble(sample, seed) & below_first_bit);
}

}  // namespace vitrine
