// How long frames took: all of them counted in buckets, the latest kept for median and 99th percentile.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine {

class FrameTimes {
 public:
  using Seconds = std::chrono::duration<double>;

  /// The upper bounds of the buckets; what is longer is in none.
  static constexpr std::array<double, 9> kBounds_s{0.005, 0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 0.64, 1.28};
  static constexpr std::size_t kLatest = 1000;

  void add(Seconds time) {
    for (std::size_t i = 0; i < kBounds_s.size(); ++i) {
      if (time.count() <= kBounds_s[i]) ++at_most_[i];
    }
    sum_ += time;
    if (latest_.size() < kLatest) {
      latest_.push_back(time.count());
    } else {
      latest_[static_cast<std::size_t>(count_ % kLatest)] = time.count();
    }
    ++count_;
  }

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] Seconds sum() const { return sum_; }
  /// How many took at most kBounds_s[i].
  [[nodiscard]] std::uint64_t at_most(std::size_t i) const { return at_most_[i]; }
  /// Of the latest kLatest; 0 before the first.
  [[nodiscard]] Seconds quantile(double q) const {
    if (latest_.empty()) return Seconds(0.0);
    std::vector<double> sorted = latest_;
    const auto rank = static_cast<std::ptrdiff_t>(q * static_cast<double>(sorted.size() - 1));
    std::ranges::nth_element(sorted, sorted.begin() + rank);
    return Seconds(sorted[static_cast<std::size_t>(rank)]);
  }

 private:
  std::array<std::uint64_t, kBounds_s.size()> at_most_{};
  std::uint64_t count_ = 0;
  Seconds sum_{0.0};
  std::vector<double> latest_;  ///< in no order
};

}  // namespace vitrine
