// Random numbers by counting: the n-th number of a sample is a hash of (seed, pixel, sample, n), so any
// sample can be made again alone, in any order, on any thread. The generator is SplitMix64 (Steele, Lea,
// Flood 2014): an odd counter through a 64-bit finaliser. Integers only.
#pragma once

#include <cstdint>

namespace vitrine {

class Sampler {
 public:
  Sampler() = default;
  Sampler(std::uint64_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t sample)
      : state_(mix(mix(seed + kStep) ^ mix((std::uint64_t{y} << 32 | x) * kStep + 1)) + mix(sample)) {}

  /// 32 random bits: the next dimension of this sample.
  std::uint32_t next_bits() {
    state_ += kStep;
    return static_cast<std::uint32_t>(mix(state_) >> 32);
  }
  /// Uniform in [0, 1).
  template <class N>
  typename N::Unit next() {
    return N::unit_from_bits(next_bits());
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15U;  // 2^64 / golden ratio, odd

  static constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  std::uint64_t state_ = 0;
};

}  // namespace vitrine
