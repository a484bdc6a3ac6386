#include "statistics/z_test.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

// Table values: two-sided 5 % of a normal distribution, and of Student's t with 10 degrees of freedom.
TEST(SidakLimit, IsTheNormalQuantile) {
  EXPECT_NEAR(sidak_limit(1, 0.05), 1.959964, 1e-5);
  EXPECT_NEAR(sidak_limit(1, 0.01), 2.575829, 1e-5);
  // Ten tests at 5 % together are each at 1 - 0.95^(1/10) = 0.5116 %.
  EXPECT_NEAR(sidak_limit(10, 0.05), 2.7996, 2e-3);
}

TEST(ZScore, OfStudentsQuantileIsTheNormalOne) {
  const Estimate ten{.mean = 2.228139, .variance = 1.0, .cumulant3 = 0.0, .freedom = 10.0};
  EXPECT_NEAR(z_score(ten, exactly(0.0)), 1.96, 0.02);
  const Estimate thirty{.mean = 3.646, .variance = 1.0, .cumulant3 = 0.0, .freedom = 30.0};
  EXPECT_NEAR(z_score(thirty, exactly(0.0)), 3.2905, 0.02);  // 0.1 %
}

TEST(ZScore, HasASign) {
  const Estimate low{.mean = 1.0, .variance = 0.01, .cumulant3 = 0.0, .freedom = 100.0};
  EXPECT_LT(z_score(low, exactly(2.0)), -5.0);
  EXPECT_GT(z_score(exactly(2.0), low), 5.0);
  EXPECT_EQ(z_score(low, low), 0.0);
}

TEST(ZScore, WithoutVarianceAllowsRoundingOnly) {
  EXPECT_EQ(z_score(exactly(1.0), exactly(1.0)), 0.0);
  EXPECT_EQ(z_score(exactly(1.0), exactly(1.001), 0.01), 0.0);
  EXPECT_EQ(z_score(exactly(1.1), exactly(1.0), 0.01), HUGE_VAL);
  EXPECT_EQ(z_score(exactly(0.9), exactly(1.0), 0.01), -HUGE_VAL);
}

// What z_score() is for: scores of means from skewed samples must be about normal, in both directions.
TEST(ZScore, OfSkewedBatchesExceedsItsLimitsAboutAsOftenAsItSays) {
  RandomInputs random(1);
  int below = 0;
  int above = 0;
  constexpr int kTrials = 20000;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> batches(32);
    for (double& x : batches) x = -std::log1p(-random.uniform());  // exponential
    const double z = z_score(estimate(batches), exactly(1.0));
    below += z < -2.3263 ? 1 : 0;  // 1 % on either side
    above += z > 2.3263 ? 1 : 0;
  }
  EXPECT_GT(below, kTrials / 250);
  EXPECT_LT(below, kTrials / 40);
  EXPECT_GT(above, kTrials / 250);
  EXPECT_LT(above, kTrials / 40);
}

TEST(Estimate, IsTheMeanWithItsVariance) {
  const Estimate e = estimate(std::vector<double>{1.0, 2.0, 3.0, 6.0});
  EXPECT_DOUBLE_EQ(e.mean, 3.0);
  EXPECT_DOUBLE_EQ(e.variance, 14.0 / 12.0);
  EXPECT_DOUBLE_EQ(e.cumulant3, (27.0 - 8.0 - 1.0) / 64.0);
  EXPECT_DOUBLE_EQ(e.freedom, 3.0);
}

}  // namespace
}  // namespace vitrine
