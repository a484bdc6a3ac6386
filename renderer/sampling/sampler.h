// The numbers of one sample. Each has a name (seed, pixel, sample, dimension) and is a function of it, so
// that any sample can be made again alone, in any order, on any thread. Which function: see sequence.h.
// Integers only.
#pragma once

#include <cstdint>

#include "sampling/sequence.h"
#include "sampling/split_mix.h"

namespace vitrine {

class Sampler {
 public:
  Sampler() = default;
  Sampler(Sequence sequence, std::uint64_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t sample);

  /// The next number will be that of this dimension. Below 2^30. Dimensions that are used together should be
  /// a pair (2k, 2k + 1), or else lie in a group of four (4k ... 4k + 3).
  void seek(std::uint32_t dimension) { dimension_ = dimension; }
  /// 32 random bits: the next dimension of this sample.
  std::uint32_t next_bits() {
    const std::uint32_t dimension = dimension_++;
    if (sequence_ == Sequence::kRandom) return static_cast<std::uint32_t>(hash(0, dimension) >> 32);
    return well_distributed_bits(*this, dimension);
  }
  /// Uniform in [0, 1).
  template <class N>
  typename N::Unit next() {
    return N::unit_from_bits(next_bits());
  }
  /// The i-th of `count` samplers that continue this sample, well distributed among themselves and together
  /// with those of other samples that split at this dimension. They have nothing to do with those of other
  /// dimensions, nor with this sampler.
  [[nodiscard]] Sampler split(std::uint32_t i, std::uint32_t count) const {
    return count <= 1 ? *this : child(i, count);
  }

 private:
  [[nodiscard]] Sampler child(std::uint32_t i, std::uint32_t count) const;
  // By value: whose address is given away is not kept in registers.
  static std::uint32_t well_distributed_bits(Sampler sampler, std::uint32_t dimension);

  [[nodiscard]] std::uint64_t hash(std::uint32_t index, std::uint32_t dimension) const {
    return split_mix(key_ + kSplitMixStep * ((std::uint64_t{index} << 32 | dimension) + 1));
  }

  std::uint64_t key_ = 0;        // the hash of whatever two samplers must differ in to be independent
  std::uint32_t index_ = 0;      // of the sample in its sequence; random: it is in the key
  std::uint32_t z_order_ = 0;    // blue noise: the pixel
  std::uint32_t dimension_ = 0;  // of the next number
  Sequence sequence_ = Sequence::kRandom;
};

}  // namespace vitrine
