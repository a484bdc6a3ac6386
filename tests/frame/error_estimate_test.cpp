#include "frame/error_estimate.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "numeric/host_conversion.h"
#include "statistics/z_test.h"

namespace vitrine {
namespace {

constexpr int kSize = 24;
constexpr Tile kAll{0, 0, kSize, kSize};

FilmValue grey(double value) { return FilmValue(static_cast<std::int64_t>(std::ldexp(value, kFilmBits))); }

/// A film whose pixels have known means and noise: exponentially distributed samples, whose standard
/// deviation is their mean, on top of a part that does not vary.
struct KnownFilm {
  static double steady(int x) { return 0.05 * x; }
  static double noisy(int x, int y) { return 0.02 + 0.01 * ((x * 7 + y * 3) % 11); }
  static double mean(int x, int y) { return steady(x) + noisy(x, y); }

  KnownFilm(std::uint32_t samples, unsigned seed) : film(kSize, kSize, 3) {
    std::mt19937 random(seed);
    std::exponential_distribution<double> exponential(1.0);
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        for (std::uint32_t i = 0; i < samples; ++i)
          film.add(x, y, grey(steady(x) + noisy(x, y) * exponential(random)));
      }
    }
  }

  /// The mean of standard deviations / sqrt(samples), over the mean.
  static double expected_error(std::uint32_t samples) {
    double deviations = 0.0;
    double means = 0.0;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        deviations += noisy(x, y) / std::sqrt(samples);
        means += mean(x, y);
      }
    }
    return deviations / means;
  }

  Film film;
};

double estimated_error(const Film& film) {
  const std::optional<Wide> error = relative_error(sum_errors(film, kAll));
  return error ? to_host(*error) : -1.0;
}

// The estimate of a pixel's variance is unbiased, so the mean over many films must hit the true one.
TEST(ErrorEstimate, PixelsHaveTheirVariance) {
  for (const std::uint32_t samples : {2U, 5U, 40U}) {
    std::vector<double> variances;
    for (unsigned seed = 0; seed < 40; ++seed) {
      const KnownFilm known(samples, 100 * samples + seed);
      double sum = 0.0;
      for (int x = 0; x < kSize; ++x) sum += to_host(pixel_error(known.film.at(x, x))->variance);
      variances.push_back(sum);
    }
    double expected = 0.0;
    for (int x = 0; x < kSize; ++x) expected += KnownFilm::noisy(x, x) * KnownFilm::noisy(x, x) / samples;
    EXPECT_LT(std::abs(z_score(estimate(variances), exactly(expected))), sidak_limit(3)) << samples;
  }
}

// The root of few samples' variance is low in the mean, that of many is not.
TEST(ErrorEstimate, IsThatOfAFilmOfKnownNoise) {
  for (const std::uint32_t samples : {8U, 512U}) {
    const double expected = KnownFilm::expected_error(samples);
    const double error = estimated_error(KnownFilm(samples, 5).film);
    EXPECT_LT(error, 1.02 * expected) << samples;
    EXPECT_GT(error, (samples < 100 ? 0.8 : 0.98) * expected) << samples;
  }
}

// What it promises: the deviation from the true picture, relative to its mean.
TEST(ErrorEstimate, PredictsTheDeviationFromTheTruePicture) {
  const KnownFilm known(64, 7);
  double deviations = 0.0;
  double means = 0.0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double mean = to_host(pixel_error(known.film.at(x, y))->mean);
      deviations += std::abs(mean - KnownFilm::mean(x, y)) * std::sqrt(std::numbers::pi / 2);  // of a normal
      means += KnownFilm::mean(x, y);
    }
  }
  const double deviation = deviations / means;
  EXPECT_NEAR(estimated_error(known.film), deviation, 0.15 * deviation);
}

TEST(ErrorEstimate, FallsWithTheRootOfTheSamples) {
  const double few = estimated_error(KnownFilm(16, 1).film);
  const double many = estimated_error(KnownFilm(16 * 64, 2).film);
  EXPECT_NEAR(few / many, 8.0, 0.8);
}

TEST(ErrorEstimate, SumsOverTilesAreThoseOfTheWhole) {
  const KnownFilm known(9, 3);
  ErrorSums sums;
  for (const Tile& tile : {Tile{0, 0, 5, kSize}, Tile{5, 0, kSize, 11}, Tile{5, 11, kSize, kSize}})
    sums += sum_errors(known.film, tile);
  EXPECT_NEAR(to_host(*relative_error(sums)), estimated_error(known.film), 1e-6);
}

TEST(ErrorEstimate, KnowsNothingOfSingleSamplesAndOfTheDark) {
  EXPECT_FALSE(relative_error(sum_errors(KnownFilm(1, 1).film, kAll)));
  Film dark(kSize, kSize, 0);
  for (int i = 0; i < 2 * kSize; ++i) dark.add(i / 2, 0, FilmValue(0));
  EXPECT_TRUE(pixel_error(dark.at(0, 0)));
  EXPECT_FALSE(relative_error(sum_errors(dark, kAll)));
}

TEST(ErrorEstimate, EqualSamplesHaveNone) {
  for (const double value : {1e-9, 0.3, 1000.0}) {
    Film film(1, 1, 0);
    for (int i = 0; i < 1000; ++i) film.add(0, 0, grey(value));
    const std::optional<Wide> error = relative_error(sum_errors(film, {0, 0, 1, 1}));
    ASSERT_TRUE(error);
    EXPECT_LT(to_host(*error), 1e-4) << value;
  }
}

// A pixel that dropped samples counts like any other, by what it has.
TEST(ErrorEstimate, TakesPixelsOfDifferentCounts) {
  Film film(2, 1, 0);
  for (const double value : {1.0, 3.0}) film.add(0, 0, grey(value));
  for (const double value : {1.0, 2.0, 3.0}) film.add(1, 0, grey(value));
  EXPECT_NEAR(to_host(pixel_error(film.at(0, 0))->variance), 1.0, 1e-6);
  EXPECT_NEAR(to_host(pixel_error(film.at(1, 0))->variance), 1.0 / 3.0, 1e-6);
  EXPECT_NEAR(to_host(*relative_error(sum_errors(film, {0, 0, 2, 1}))), (1.0 + std::sqrt(1.0 / 3.0)) / 4.0,
              1e-6);
}

}  // namespace
}  // namespace vitrine
