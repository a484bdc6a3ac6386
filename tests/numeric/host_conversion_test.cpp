#include "numeric/host_conversion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "number_systems.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

constexpr int kValues = 100000;

template <class N>
class HostConversionTest : public testing::Test {};
TYPED_TEST_SUITE(HostConversionTest, NumberSystems, NumberSystemNames);

TYPED_TEST(HostConversionTest, RoundTrip) {
  RandomInputs random(1);
  for (int i = 0; i < kValues; ++i) {
    const double x = random.uniform(-3.99, 3.99);
    ASSERT_NEAR(to_host(from_host<typename TypeParam::Unit>(x)), x, bound<TypeParam>(0x1p-23, 0x1p-30));
    ASSERT_NEAR(to_host(from_host<typename TypeParam::Length>(2 * x)), 2 * x,
                bound<TypeParam>(0x1p-22, 0x1p-29));
    const double wide = random.log_uniform(1e-30, 1e30);
    ASSERT_NEAR(to_host(from_host<typename TypeParam::Density>(wide)) / wide, 1.0,
                bound<TypeParam>(0x1p-24, 0x1p-31));
  }
  EXPECT_EQ(to_host(from_host<typename TypeParam::Density>(0.0)), 0.0);
}

TYPED_TEST(HostConversionTest, ConstantsAgree) {
  EXPECT_EQ(from_host<typename TypeParam::Unit>(0.7), typename TypeParam::Unit(0.7));
  EXPECT_EQ(from_host<typename TypeParam::Unit>(-0.7), typename TypeParam::Unit(-0.7));
  EXPECT_EQ(from_host<typename TypeParam::Density>(0.7), typename TypeParam::Density(0.7));
}

TYPED_TEST(HostConversionTest, Vectors) {
  using Length = typename TypeParam::Length;
  const glm::dvec3 v(0.5, -0.25, 2.0);
  EXPECT_EQ(to_host(from_host<Length>(v)), v);
  EXPECT_EQ(to_host(from_host<Length>(glm::vec3(v))), v);
}

TEST(FixedHostConversionTest, Saturates) {
  EXPECT_EQ(from_host<FixedUnit>(4.0).raw, INT32_MAX);
  EXPECT_EQ(from_host<FixedUnit>(1e300).raw, INT32_MAX);
  EXPECT_EQ(from_host<FixedUnit>(-1e300).raw, -INT32_MAX);
  EXPECT_EQ(from_host<FixedLength>(-9.0).raw, -INT32_MAX);
  EXPECT_GE(to_host(from_host<FixedNumbers::Area>(1e300)), 127.999);
  EXPECT_LE(to_host(from_host<FixedNumbers::Area>(-1e300)), -127.999);
  EXPECT_EQ(from_host<Wide>(-1.0), Wide::zero());
  EXPECT_EQ(from_host<Wide>(std::nan("")), Wide::zero());
}

}  // namespace
}  // namespace vitrine
