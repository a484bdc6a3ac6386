// A discrete distribution by Vose's alias method (1991): one 32-bit number and one table look-up a sample.
// prob() tells the probability that is really sampled, the share of all 2^32 numbers that lead there, so that
// dividing by it is exact in both number systems.
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
      entries_[below] = {threshold(scaled[below]), above, {}};
      scaled[above] -= 1.0 - scaled[below];
      if (scaled[above] < 1.0) {
        large.pop_back();
        small.push_back(above);
      }
    }
    for (const std::uint32_t i : large)
      entries_[i] = {kAlways, i, {}};  // its own alias: the threshold is idle
    for (const std::uint32_t i : small) entries_[i] = {kAlways, i, {}};  // left over by rounding: they are 1
    count_probabilities();
  }

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(entries_.size()); }
  /// The outcome for 32 random bits. Their product with the number of entries is an entry (the high word) and
  /// what decides between it and its alias (the low word).
  [[nodiscard]] std::uint32_t sample(std::uint32_t bits) const {
    const std::uint64_t product = std::uint64_t{bits} * entries_.size();
    const auto i = static_cast<std::uint32_t>(product >> 32);
    const Entry& entry = entries_[i];
    return static_cast<std::uint32_t>(product) < entry.threshold ? i : entry.alias;
  }
  [[nodiscard]] typename N::Density prob(std::uint32_t i) const { return entries_[i].prob; }

 private:
  static constexpr std::uint32_t kAlways = 0xffffffffU;
  struct Entry {
    std::uint32_t threshold = kAlways;
    std::uint32_t alias = 0;
    typename N::Density prob{};
  };

  // What has a weight can be sampled, what has none cannot: the low words of an entry are less than the
  // number of entries apart.
  [[nodiscard]] std::uint32_t threshold(double x) const {
    if (!(x > 0.0)) return 0;
    return static_cast<std::uint32_t>(
        std::clamp(std::ceil(x * 0x1p32), static_cast<double>(entries_.size()), 0x1p32 - 1.0));
  }

  void count_probabilities() {
    const std::uint64_t n = entries_.size();
    std::vector<std::uint64_t> ways(entries_.size(), 0);  // of 2^32
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const auto first_of = [&](std::uint64_t entry) { return ((entry << 32) + n - 1) / n; };
      const std::uint64_t all = first_of(i + 1) - first_of(i);
      const std::uint64_t first_word = first_of(i) * n - (std::uint64_t{i} << 32);
      const std::uint64_t limit = entries_[i].threshold;
      const std::uint64_t own = first_word < limit ? (limit - 1 - first_word) / n + 1 : 0;
      ways[i] += own;
      ways[entries_[i].alias] += all - own;
    }
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      entries_[i].prob = from_host<typename N::Density>(static_cast<double>(ways[i]) * 0x1p-32);
    }
  }

  std::vector<Entry> entries_;
};

}  // namespace vitrine
