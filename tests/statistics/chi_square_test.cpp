#include "statistics/chi_square.h"

#include <array>

#include <gtest/gtest.h>

#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

// Of tables of the chi-square distribution: the statistic that is exceeded with probability 0.05 and 0.001.
TEST(ChiSquareTest, HasTheTabulatedTails) {
  struct Row {
    int degrees;
    double five_percent;
    double one_permille;
  };
  for (const Row& row :
       {Row{1, 3.841459, 10.827566}, Row{2, 5.991465, 13.815511}, Row{10, 18.307038, 29.588298},
        Row{100, 124.342113, 149.449253}, Row{1000, 1074.679449, 1143.917145}}) {
    EXPECT_NEAR(upper_incomplete_gamma(0.5 * row.degrees, 0.5 * row.five_percent), 0.05, 1e-6) << row.degrees;
    EXPECT_NEAR(upper_incomplete_gamma(0.5 * row.degrees, 0.5 * row.one_permille), 0.001, 1e-6)
        << row.degrees;
  }
  EXPECT_EQ(upper_incomplete_gamma(3.0, 0.0), 1.0);
  EXPECT_LT(upper_incomplete_gamma(3.0, 1000.0), 1e-300);
}

TEST(ChiSquareTest, SumsSquaredDifferences) {
  const std::array<double, 3> expected{10.0, 20.0, 30.0};
  const std::array<std::uint64_t, 3> observed{12, 16, 32};
  const ChiSquare result = chi_square(expected, observed);
  EXPECT_DOUBLE_EQ(result.statistic, 4.0 / 10 + 16.0 / 20 + 4.0 / 30);
  EXPECT_EQ(result.degrees, 2);
}

TEST(ChiSquareTest, PoolsSmallCells) {
  const std::array<double, 6> expected{100.0, 1.0, 2.0, 3.0, 50.0, 1.0};
  const std::array<std::uint64_t, 6> observed{100, 2, 1, 4, 50, 0};
  const ChiSquare result = chi_square(expected, observed);
  EXPECT_EQ(result.degrees, 2);  // 1 + 1 + 2 + 3, 50, 100
  EXPECT_DOUBLE_EQ(result.statistic, 0.0);
  // What is too small at the end joins the last cell.
  EXPECT_EQ(chi_square(std::array{4.0, 4.0, 4.0}, std::array<std::uint64_t, 3>{4, 4, 4}).degrees, 0);
}

TEST(ChiSquareTest, RefusesTheImpossible) {
  EXPECT_EQ(chi_square(std::array{1000.0, 0.0}, std::array<std::uint64_t, 2>{999, 1}).p_value, 0.0);
  EXPECT_EQ(chi_square(std::array{1000.0, 0.0}, std::array<std::uint64_t, 2>{1000, 0}).p_value, 1.0);
}

// p-values of a true hypothesis are uniform: not small more often than they may be, and not never.
TEST(ChiSquareTest, IsFooledAsOftenAsItSays) {
  RandomInputs random(1);
  int below = 0;
  constexpr int kTrials = 4000;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::array<std::uint64_t, 32> observed{};
    for (int i = 0; i < 1000; ++i) ++observed[random.index(observed.size())];
    below += chi_square_uniform(observed).p_value < 0.05;
  }
  EXPECT_NEAR(below, 0.05 * kTrials, 4.0 * std::sqrt(0.05 * 0.95 * kTrials));
}

TEST(ChiSquareTest, SidakKeepsTheChanceOfAnyFalseAlarm) {
  for (const int tests : {1, 10, 500}) {
    EXPECT_NEAR(1.0 - std::pow(1.0 - sidak(tests), tests), kSignificance, 1e-12);
  }
}

}  // namespace
}  // namespace vitrine
