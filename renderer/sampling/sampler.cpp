#include "sampling/sampler.h"

#include "sampling/owen_scramble.h"
#include "sampling/screen_sobol.h"
#include "sampling/sobol.h"
#include "sampling/strata.h"

namespace vitrine {

Sampler::Sampler(Sequence sequence, std::uint64_t seed, std::uint32_t x, std::uint32_t y,
                 std::uint32_t sample)
    : index_(sample), sequence_(sequence) {
  const std::uint64_t seed_hash = split_mix(seed + kSplitMixStep);
  const std::uint64_t pixel_hash = split_mix((std::uint64_t{y} << 32 | x) * kSplitMixStep + 1);
  switch (sequence) {
    case Sequence::kRandom:
      key_ = split_mix(seed_hash ^ pixel_hash) + split_mix(sample);
      break;
    case Sequence::kGrid:  // the same in every pixel, whatever the seed
      break;
    case Sequence::kStratified:
    case Sequence::kSobol:
      key_ = split_mix(seed_hash ^ pixel_hash);
      break;
    case Sequence::kBlueNoise:  // one sequence for all pixels of 65536 x 65536
      key_ = split_mix(seed_hash ^ split_mix(std::uint64_t{y >> 16} << 32 | x >> 16));
      z_order_ = z_order(x, y, static_cast<std::uint32_t>(key_ >> 32));
      break;
  }
}

Sampler Sampler::child(std::uint32_t i, std::uint32_t count) const {
  Sampler child = *this;
  if (sequence_ == Sequence::kRandom) {
    child.key_ = split_mix(key_ ^ split_mix(kSplitMixStep * (std::uint64_t{dimension_} << 32 | (i + 1))));
    return child;
  }
  // Siblings and cousins share a sequence, of which each family has consecutive points. What goes beyond 32
  // bits of index begins other sequences.
  const std::uint64_t index = std::uint64_t{index_} * count + i;
  child.index_ = static_cast<std::uint32_t>(index);
  child.key_ = split_mix(key_ ^ split_mix(kSplitMixStep * (std::uint64_t{dimension_} << 32 | count)));
  if (index >> 32 != 0) child.key_ ^= split_mix(kSplitMixStep * (index >> 32));
  return child;
}

// Dimensions of a group are coordinates of one sequence. Another group goes through it in another order, or
// the two would be one.
std::uint32_t Sampler::well_distributed_bits(Sampler s, std::uint32_t dimension) {
  constexpr std::uint32_t kOrder = 1U << 31;    // no dimension: names the order of a group
  constexpr std::uint32_t kInPixel = 1U << 30;  // and this the part of it that is the pixel's own
  const auto low = [](std::uint64_t hash) { return static_cast<std::uint32_t>(hash); };
  const auto high = [](std::uint64_t hash) { return static_cast<std::uint32_t>(hash >> 32); };
  const auto scramble = [&](std::uint32_t reversed) {
    return reverse_bits(owen_scramble_reversed(reversed, high(s.hash(0, dimension))));
  };
  const std::uint32_t pair = dimension / 2;
  const std::uint32_t group = dimension / 4;
  switch (s.sequence_) {
    case Sequence::kRandom:
      break;
    case Sequence::kGrid:
    case Sequence::kStratified: {
      constexpr std::uint32_t kCellBits = 29;
      const std::uint64_t order = s.hash(s.index_ / kStrata, kOrder | pair);
      const std::uint32_t cell = stratum(s.index_ % kStrata, dimension % 2, low(order), high(order));
      const std::uint32_t within =
          s.sequence_ == Sequence::kGrid ? 1U << (kCellBits - 1) : high(s.hash(s.index_, dimension)) >> 3;
      return cell << kCellBits | within;
    }
    case Sequence::kSobol: {
      const std::uint32_t index = owen_scramble(s.index_, low(s.hash(0, kOrder | group)));
      return scramble(sobol(index, dimension % 4));
    }
    case Sequence::kBlueNoise: {
      // Times w, or the four coordinates would go together in the same way in all of a square's pixels.
      const std::uint32_t z_order = pair % 2 == 0 ? s.z_order_ : times_w(s.z_order_);
      const std::uint32_t pixel = owen_scramble_reversed(z_order, high(s.hash(0, kOrder | pair)));
      const std::uint32_t in_pixel =
          reorder_within_octaves(s.index_, low(s.hash(s.z_order_, kOrder | kInPixel | group)));
      const std::uint32_t sample = owen_scramble(in_pixel, low(s.hash(0, kOrder | group * 2)));
      return scramble(screen_sobol(pixel, sample, dimension % 4));
    }
  }
  return high(s.hash(0, dimension));
}

}  // namespace vitrine
