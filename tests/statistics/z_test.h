// Are two means the same? Welch's test of means that were estimated from independent batches, each with its
// own variance, as a standard normal score; and the limit that a score must stay below when many are tested
// at once (Sidak 1967). Seeds are fixed, so a test either always passes or always fails; the limits say how
// unlikely it was to meet an unlucky seed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace vitrine {

/// A mean as it is known from batches: the variance and the third cumulant of that mean, and the degrees of
/// freedom with which they are known.
struct Estimate {
  double mean = 0.0;
  double variance = 0.0;
  double cumulant3 = 0.0;
  double freedom = 1.0;
};

/// The mean of at least two independent, equally distributed batches.
inline Estimate estimate(std::span<const double> batches) {
  const auto count = static_cast<double>(batches.size());
  double sum = 0.0;
  for (const double x : batches) sum += x;
  const double mean = sum / count;
  double squares = 0.0;
  double cubes = 0.0;
  for (const double x : batches) {
    squares += (x - mean) * (x - mean);
    cubes += (x - mean) * (x - mean) * (x - mean);
  }
  return {mean, squares / (count * (count - 1.0)), cubes / (count * count * count), count - 1.0};
}

/// What is known exactly, as an estimate.
inline Estimate exactly(double value) { return {.mean = value}; }

/// How many standard deviations of a normal distribution a lies above b. Differences up to `rounding` do not
/// count: where an estimator has no variance, that of the arithmetic is left.
///
/// Light that is found rarely and then counts much makes the mean of too few samples low and its variance too
/// small as well. Hall's transformation (1992, "On the removal of skewness by transformation") takes the
/// skewness of the batches into account: such a mean may be low, but so much less be high.
inline double z_score(const Estimate& a, const Estimate& b, double rounding = 0.0) {
  const double all = a.mean - b.mean;
  const double difference = std::copysign(std::max(0.0, std::abs(all) - rounding), all);
  if (difference == 0.0) return 0.0;
  const double variance = a.variance + b.variance;
  if (variance == 0.0) return std::copysign(HUGE_VAL, difference);
  const double deviation = std::sqrt(variance);
  const double student = difference / deviation;
  const double skewness = (a.cumulant3 - b.cumulant3) / (variance * deviation);
  const double t = student + skewness / 3.0 * student * student +
                   skewness * skewness / 27.0 * student * student * student + skewness / 6.0;
  const double freedom =
      variance * variance / (a.variance * a.variance / a.freedom + b.variance * b.variance / b.freedom);
  // Student's t as a normal score (Wallace 1959), within 0.02 from 5 degrees of freedom on.
  const double z =
      (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0) * std::sqrt(freedom * std::log1p(t * t / freedom));
  return std::copysign(z, t);
}

/// The |z| that the largest of `tests` independent normal scores exceeds with probability `significance`.
inline double sidak_limit(std::size_t tests, double significance = 1e-4) {
  const double each =
      -std::expm1(std::log1p(-significance) / static_cast<double>(std::max<std::size_t>(1, tests)));
  double low = 0.0;
  double high = 40.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (std::erfc(middle / std::numbers::sqrt2) > each ? low : high) = middle;
  }
  return high;
}

}  // namespace vitrine
