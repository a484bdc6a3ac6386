// A discrete distribution by Vose's alias method (1991): one table look-up a sample. Probabilities are
// integers of 2^-32, and prob() tells the probability that is really sampled, so that dividing by it is exact
// in both number systems.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "numeric/fixed.h"
#include "numeric/host_conversion.h"

namespace vitrine {

template <class N>
class DiscreteDistribution {
 public:
  DiscreteDistribution() = default;
  /// `weights`: at least one, none negative, not all zero. Built on the host.
  explicit DiscreteDistribution(std::span<const double> weights) : entries_(weights.size()) {
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    const auto count = static_cast<double>(weights.size());
    std::vector<double> scaled(weights.size());
    std::vector<std::uint32_t> small;
    std::vector<std::uint32_t> large;
    for (std::uint32_t i = 0; i < weights.size(); ++i) {
      scaled[i] = weights[i] / total * count;
      (scaled[i] < 1.0 ? small : large).push_back(i);
    }
    while (!small.empty() && !large.empty()) {
      const std::uint32_t below = small.back();
      small.pop_back();
      const std::uint32_t above = large.back();
      entries_[below] = {quantized(scaled[below]), above, {}};
      scaled[above] -= 1.0 - scaled[below];
      if (scaled[above] < 1.0) {
        large.pop_back();
        small.push_back(above);
      }
    }
    for (const std::uint32_t i : large)
      entries_[i] = {kAlways, i, {}};  // its own alias: the threshold is idle
    for (const std::uint32_t i : small) entries_[i] = {kAlways, i, {}};  // left over by rounding: they are 1
    compute_probabilities();
  }

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(entries_.size()); }
  /// The outcome for 64 random bits; the first 32 choose the entry, the second its alias.
  [[nodiscard]] std::uint32_t sample(std::uint32_t bits, std::uint32_t alias_bits) const {
    const auto i = static_cast<std::uint32_t>((std::uint64_t{bits} * entries_.size()) >> 32);
    const Entry& entry = entries_[i];
    return alias_bits < entry.threshold ? i : entry.alias;
  }
  [[nodiscard]] typename N::Density prob(std::uint32_t i) const { return entries_[i].prob; }

 private:
  static constexpr std::uint32_t kAlways = 0xffffffffU;
  struct Entry {
    std::uint32_t threshold = kAlways;
    std::uint32_t alias = 0;
    typename N::Density prob{};
  };

  // Rounded up: what has a weight can be sampled, what has none cannot.
  static std::uint32_t quantized(double x) {
    return static_cast<std::uint32_t>(std::min(std::ceil(x * 0x1p32), 0x1p32 - 1.0));
  }

  void compute_probabilities() {
    std::vector<double> prob(entries_.size(), 0.0);
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const double own = static_cast<double>(entries_[i].threshold) * 0x1p-32;
      prob[i] += own;
      prob[entries_[i].alias] += 1.0 - own;
    }
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      entries_[i].prob = from_host<typename N::Density>(prob[i] / static_cast<double>(entries_.size()));
    }
  }

  std::vector<Entry> entries_;
};

}  // namespace vitrine
