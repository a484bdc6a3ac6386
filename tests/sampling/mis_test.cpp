#include "sampling/mis.h"

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/host_conversion.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

template <class N>
class MisTest : public testing::Test {};
TYPED_TEST_SUITE(MisTest, NumberSystems, NumberSystemNames);

TYPED_TEST(MisTest, WeightsAreRatiosAndSumToOne) {
  using Density = typename TypeParam::Density;
  RandomInputs random(1);
  const double tolerance = bound<TypeParam>(3e-7, 6e-9);
  for (int i = 0; i < 100000; ++i) {
    const auto a = from_host<Density>(random.log_uniform(1e-9, 1e9));
    const auto b = from_host<Density>(to_host(a) * random.log_uniform(1e-3, 1e3));
    const double ratio = to_host(b) / to_host(a);
    for (const MisHeuristic heuristic : {MisHeuristic::kBalance, MisHeuristic::kPower}) {
      const double other = heuristic == MisHeuristic::kPower ? ratio * ratio : ratio;
      const double weight = to_host(mis_weight<TypeParam>(heuristic, a, b));
      ASSERT_NEAR(weight, 1.0 / (1.0 + other), tolerance) << ratio;
      ASSERT_NEAR(weight + to_host(mis_weight<TypeParam>(heuristic, b, a)), 1.0, tolerance) << ratio;
    }
  }
}

TYPED_TEST(MisTest, Extremes) {
  using Density = typename TypeParam::Density;
  for (const MisHeuristic heuristic : {MisHeuristic::kBalance, MisHeuristic::kPower}) {
    const auto weight = [&](Density a, Density b) { return to_host(mis_weight<TypeParam>(heuristic, a, b)); };
    EXPECT_EQ(weight(Density(2), Density(0)), 1.0);
    EXPECT_EQ(weight(Density(0), Density(2)), 0.0);
    EXPECT_NEAR(weight(Density(3), Density(3)), 0.5, 1e-8);
    EXPECT_EQ(weight(Density(1e30), Density(1e-30)), 1.0) << "whose squares no float holds";
    EXPECT_EQ(weight(Density(1e-30), Density(1e30)), 0.0);
    EXPECT_NEAR(weight(Density(1e30), Density(1e30)), 0.5, 1e-8);
    EXPECT_NEAR(weight(Density(1e-30), Density(1e-30)), 0.5, 1e-8);
  }
}

}  // namespace
}  // namespace vitrine
