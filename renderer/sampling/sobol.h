// A sequence of points in four dimensions: Sobol's first two, and the same two of another index. Sobol's pair
// is the index's bits and Pascal's matrix P (binomials modulo 2) times them, lowest bit first. The other
// index is P^w times the bits in twos, as digits of the field GF(4) = {0, 1, w, w^2}: P^a has the entries
// binom(j, i) a^(j-i), so that P^a P^b = P^(a+b). The coordinates are then P^0, P^1, P^w, P^(w+1) times the
// index: Niederreiter's (0,4)-sequence in base 4 (1987), whose pairs (0,1) and (2,3) are (0,2)-sequences in
// base 2. Ahmed et al. (2023, "SZ Sequences") found such ensembles by search. No tables: the matrices are
// products of sparse ones.
#pragma once

#include <cstdint>

namespace vitrine {

/// Pascal's matrix times 32 bits. By Lucas's theorem binom(j, i) is odd when i's bits are among j's, so there
/// is one factor for each bit of the position.
constexpr std::uint32_t pascal(std::uint32_t bits) {
  bits ^= bits >> 1 & 0x55555555U;
  bits ^= bits >> 2 & 0x33333333U;
  bits ^= bits >> 4 & 0x0f0f0f0fU;
  bits ^= bits >> 8 & 0x00ff00ffU;
  return bits ^ bits >> 16;
}

/// Each of 16 digits of GF(4) times w, and times w^2 = w + 1.
constexpr std::uint32_t times_w(std::uint32_t digits) {
  constexpr std::uint32_t kLow = 0x55555555U;
  return ((digits ^ digits >> 1) & kLow) | (digits & kLow) << 1;
}
constexpr std::uint32_t times_w2(std::uint32_t digits) { return digits ^ times_w(digits); }

/// P^w times 16 digits of GF(4), lowest first. Its own inverse, as w + w = 0.
constexpr std::uint32_t pascal_w(std::uint32_t digits) {
  digits ^= times_w(digits >> 2) & 0x33333333U;
  digits ^= times_w2(digits >> 4) & 0x0f0f0f0fU;
  digits ^= times_w(digits >> 8) & 0x00ff00ffU;
  return digits ^ times_w2(digits >> 16);
}

/// Coordinate 0, 1, 2 or 3 of a point, its first binary digit in the lowest bit. Any 2^m points whose indices
/// differ in the last m bits only are a (0,m,2)-net in base 2 in coordinates (0,1) and in (2,3); 4^m are a
/// (0,m,4)-net in base 4.
constexpr std::uint32_t sobol(std::uint32_t index, std::uint32_t coordinate) {
  if (coordinate >= 2) index = pascal_w(index);
  return coordinate % 2 == 0 ? index : pascal(index);
}

}  // namespace vitrine
