// Owen's nested uniform scrambling (1995) by a hash: each bit of a number is flipped or not, as the bits
// above it say. A net stays a net, yet each of its points is uniform; an index stays in its aligned blocks,
// yet their order is another. Laine and Karras (2011) have hashes in which a bit depends on the bits below it
// only; Burley (2020, "Practical Hash-based Owen Scrambling") reverses the bits and has the scrambling; the
// constants are Vegdahl's better ones (2021).
#pragma once

#include <cstdint>

namespace vitrine {

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
  x = (x >> 1 & 0x55555555U) | (x & 0x55555555U) << 1;
  x = (x >> 2 & 0x33333333U) | (x & 0x33333333U) << 2;
  x = (x >> 4 & 0x0f0f0f0fU) | (x & 0x0f0f0f0fU) << 4;
  x = (x >> 8 & 0x00ff00ffU) | (x & 0x00ff00ffU) << 8;
  return x >> 16 | x << 16;
}

/// Scrambles a number whose first digit is its lowest bit. The seed must be well mixed.
constexpr std::uint32_t owen_scramble_reversed(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= seed >> 16 | 1U;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return x;
}

/// Scrambles a number whose first digit is its highest bit: a coordinate, or an index.
constexpr std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
  return reverse_bits(owen_scramble_reversed(reverse_bits(x), seed));
}

}  // namespace vitrine
