// The hash that names become random numbers by: SplitMix64's 64-bit finaliser (Steele, Lea, Flood 2014). As a
// generator it is fed an odd counter; as a hash, what has been said so far times that odd step.
#pragma once

#include <cstdint>

namespace vitrine {

inline constexpr std::uint64_t kSplitMixStep = 0x9e3779b97f4a7c15U;  // 2^64 / golden ratio, odd

/// A bijection in which every bit of the result depends on every bit of `z`; 0 stays 0.
constexpr std::uint64_t split_mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

}  // namespace vitrine
