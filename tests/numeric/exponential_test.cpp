#include "numeric/exponential.h"

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/host_conversion.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

template <class N>
class ExponentialTest : public testing::Test {};
TYPED_TEST_SUITE(ExponentialTest, NumberSystems, NumberSystemNames);

// The error of a result is its relative own, and that of the argument's last digit.
TYPED_TEST(ExponentialTest, ExpOfNegatives) {
  using Density = typename TypeParam::Density;
  RandomInputs random(1);
  for (int i = 0; i < 200000; ++i) {
    const auto x = from_host<Density>(random.log_uniform(1e-10, 80.0));
    const double exact = std::exp(-to_host(x));
    const double tolerance = bound<TypeParam>(2e-7, 6e-9) * (1.0 + to_host(x) / 8.0);
    ASSERT_NEAR(to_host(exp_negative(x)), exact, exact * tolerance) << to_host(x);
  }
  EXPECT_EQ(to_host(exp_negative(Density(0))), 1.0);
  EXPECT_EQ(to_host(exp_negative(Density(1e-30))), 1.0);
}

TYPED_TEST(ExponentialTest, PowersOfUnits) {
  using Unit = typename TypeParam::Unit;
  using Density = typename TypeParam::Density;
  RandomInputs random(2);
  for (int i = 0; i < 200000; ++i) {
    const auto base = from_host<Unit>(i % 2 == 0 ? random.uniform() : random.log_uniform(1e-6, 1.0));
    const auto exponent = from_host<Density>(random.log_uniform(1e-3, 300.0));
    const double exact = std::pow(to_host(base), to_host(exponent));
    if (exact < 1e-30 || base == Unit(0)) continue;
    const double tolerance =
        bound<TypeParam>(2e-7, 8e-9) * (1.0 + to_host(exponent) - 0.125 * std::log2(exact));
    ASSERT_NEAR(to_host(pow(base, exponent)), exact, exact * tolerance)
        << to_host(base) << ' ' << to_host(exponent);
  }
}

TYPED_TEST(ExponentialTest, PowersAtTheEnds) {
  using Unit = typename TypeParam::Unit;
  using Density = typename TypeParam::Density;
  EXPECT_EQ(to_host(pow(Unit(0), Density(3))), 0.0);
  EXPECT_EQ(to_host(pow(Unit(0), Density(0))), 1.0);
  EXPECT_EQ(to_host(pow(Unit(0.3), Density(0))), 1.0);
  EXPECT_EQ(to_host(pow(Unit(1), Density(1000))), 1.0);
  EXPECT_EQ(to_host(Unit(pow(Unit(0.5), Density(1e6)))), 0.0);
  EXPECT_NEAR(to_host(pow(Unit(0.25), Density(0.5))), 0.5, 1e-8);
}

// What no float can hold, and what an absorbing volume of any thickness asks for.
TEST(FixedExponentialTest, ReachesFarBelowOne) {
  const double exact = std::exp(-700.0);
  EXPECT_NEAR(to_host(exp_negative(Wide(700))) / exact, 1.0, 1e-6);
  EXPECT_EQ(exp_negative(Wide(1e9)), Wide::zero());
  EXPECT_EQ(exp_negative(Wide::huge()), Wide::zero());
}

}  // namespace
}  // namespace vitrine
