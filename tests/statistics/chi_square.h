// Pearson's chi-square test: do counts follow the expected ones? Cells too small for its approximation are
// pooled. Whoever makes many comparisons corrects the significance for their number (Sidak 1967), or finds
// false alarms.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "statistics/incomplete_gamma.h"

namespace vitrine {

/// The chance that any of our comparisons fails though all is well.
inline constexpr double kSignificance = 0.01;

/// What one of `tests` independent comparisons may use of kSignificance.
inline double sidak(int tests) { return 1.0 - std::pow(1.0 - kSignificance, 1.0 / tests); }

struct ChiSquare {
  double statistic = 0.0;
  int degrees = 0;
  /// How probable so large a statistic is when the counts do follow; 0 when something impossible was counted.
  double p_value = 1.0;
};

/// `expected`: counts, that sum to the number of samples.
inline ChiSquare chi_square(std::span<const double> expected, std::span<const std::uint64_t> observed) {
  constexpr double kSmallest = 5.0;
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return expected[i]; });

  ChiSquare result{.degrees = -1};
  double pooled_expected = 0.0;
  double pooled_observed = 0.0;
  double left = std::accumulate(expected.begin(), expected.end(), 0.0);
  for (const std::size_t i : order) {
    if (expected[i] <= 0.0 && observed[i] > 0) {
      return {.statistic = std::numeric_limits<double>::infinity(), .degrees = 0, .p_value = 0.0};
    }
    pooled_expected += expected[i];
    pooled_observed += static_cast<double>(observed[i]);
    left -= expected[i];
    const bool last = i == order.back();
    if (!last && (pooled_expected < kSmallest || left < kSmallest)) continue;
    if (pooled_expected > 0.0) {
      const double difference = pooled_observed - pooled_expected;
      result.statistic += difference * difference / pooled_expected;
      ++result.degrees;
    }
    pooled_expected = pooled_observed = 0.0;
  }
  result.degrees = std::max(result.degrees, 0);
  if (result.degrees > 0) {
    result.p_value = upper_incomplete_gamma(0.5 * result.degrees, 0.5 * result.statistic);
  }
  return result;
}

/// For outcomes that are all as likely.
inline ChiSquare chi_square_uniform(std::span<const std::uint64_t> observed) {
  const auto total = static_cast<double>(std::accumulate(observed.begin(), observed.end(), std::uint64_t{0}));
  const std::vector<double> expected(observed.size(), total / static_cast<double>(observed.size()));
  return chi_square(expected, observed);
}

}  // namespace vitrine
