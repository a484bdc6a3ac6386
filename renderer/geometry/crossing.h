// A random number for each meeting of a ray with a triangle, made of nothing but the two: whoever asks, in
// whatever order and on whatever thread, is told the same. Integers only.
#pragma once

#include <cstdint>

#include "geometry/ray.h"
#include "sampling/split_mix.h"

namespace vitrine {

/// 32 random bits, independent between rays that differ in any bit and between triangles.
template <class N>
constexpr std::uint32_t crossing_bits(const Ray<N>& ray, std::uint32_t triangle) {
  const auto two = [](auto a, auto b) { return std::uint64_t{N::bits_of(a)} << 32 | N::bits_of(b); };
  std::uint64_t z = 0;
  for (const std::uint64_t word : {two(ray.origin.x, ray.origin.y), two(ray.origin.z, ray.direction.x),
                                   two(ray.direction.y, ray.direction.z), std::uint64_t{triangle}}) {
    z = (z ^ word) * kSplitMixStep;
    z ^= z >> 32;
  }
  return static_cast<std::uint32_t>(split_mix(z) >> 32);
}

}  // namespace vitrine
