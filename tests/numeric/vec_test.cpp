#include "numeric/vec.h"

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/color.h"
#include "numeric/host_conversion.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

constexpr int kVectors = 200000;

template <class N>
class VecTest : public testing::Test {};
TYPED_TEST_SUITE(VecTest, NumberSystems, NumberSystemNames);

TYPED_TEST(VecTest, DotAndCrossOfUnitVectors) {
  using Unit = typename TypeParam::Unit;
  RandomInputs random(1);
  const double tolerance = bound<TypeParam>(0x1p-22, 0x1p-30);
  for (int i = 0; i < kVectors; ++i) {
    const auto a = from_host<Unit>(random.direction());
    const auto b = from_host<Unit>(random.direction());
    ASSERT_NEAR(to_host(dot(a, b)), glm::dot(to_host(a), to_host(b)), tolerance);
    const glm::dvec3 difference = to_host(cross(a, b)) - glm::cross(to_host(a), to_host(b));
    ASSERT_LE(max_component(glm::abs(difference)), tolerance);
  }
}

TYPED_TEST(VecTest, NormalizeAnyLength) {
  using Length = typename TypeParam::Length;
  RandomInputs random(2);
  for (int i = 0; i < kVectors; ++i) {
    const auto a = from_host<Length>(random.direction() * random.log_uniform(1e-7, 4.0));
    const glm::dvec3 exact = to_host(a);
    const glm::dvec3 error = to_host(normalize(a)) - exact / glm::length(exact);
    ASSERT_LE(max_component(glm::abs(error)), bound<TypeParam>(0x1p-22, 0x1p-28)) << exact.x;
  }
}

TYPED_TEST(VecTest, LengthOfAnyLength) {
  using Length = typename TypeParam::Length;
  RandomInputs random(3);
  for (int i = 0; i < kVectors; ++i) {
    const auto a = from_host<Length>(random.direction() * random.log_uniform(1e-7, 7.0));
    const double exact = glm::length(to_host(a));
    ASSERT_NEAR(to_host(length(a)), exact,
                exact * bound<TypeParam>(0x1p-22, 0x1p-29) + bound<TypeParam>(0.0, 0x1p-29))
        << exact;
  }
}

TYPED_TEST(VecTest, QuantitiesMixByComponent) {
  using Unit = typename TypeParam::Unit;
  using Length = typename TypeParam::Length;
  using Weight = typename TypeParam::Weight;
  const Vec3<Length> lengths(Length(1), Length(-2), Length(3));
  const Vec3<Unit> units(Unit(0.5), Unit(0.25), Unit(-1));
  EXPECT_EQ(lengths * Unit(0.5), Vec3<Length>(Length(0.5), Length(-1), Length(1.5)));
  EXPECT_EQ(lengths * units, Vec3<Length>(Length(0.5), Length(-0.5), Length(-3)));
  const Vec3<Weight> weights(Weight(1), Weight(2), Weight(3));
  EXPECT_EQ(weights * Unit(0.5), Vec3<Weight>(Weight(0.5), Weight(1), Weight(1.5)));
  EXPECT_EQ(weights * weights, Vec3<Weight>(Weight(1), Weight(4), Weight(9)));
  EXPECT_EQ(Vec2<Length>(Length(1), Length(2)) * Unit(0.5), Vec2<Length>(Length(0.5), Length(1)));
}

TYPED_TEST(VecTest, LargestComponentAndLuminance) {
  using Unit = typename TypeParam::Unit;
  const Unit a(0.25);
  const Unit b(0.5);
  const Unit c(-1);
  for (const Vec3<Unit>& v : {Vec3<Unit>(a, b, c), Vec3<Unit>(b, a, c), Vec3<Unit>(c, a, b)}) {
    EXPECT_EQ(max_component(v), b);
  }
  const double tolerance = bound<TypeParam>(1e-7, 4e-9);
  EXPECT_NEAR(to_host(luminance<Unit>(Vec3<Unit>(1))), 1.0, tolerance);
  EXPECT_NEAR(to_host(luminance<Unit>(Vec3<Unit>(a, b, a))), 0.25 + 0.25 * 0.7152, tolerance);
}

TEST(FixedVecTest, NormalizeTheSmallestAndTheLargest) {
  const auto along_x = [](std::int32_t raw) {
    return normalize(Vec3<FixedLength>(FixedLength::from_raw(raw), FixedLength(0), FixedLength(0)));
  };
  for (const std::int32_t raw : {1, 2, 3, 1000, 1 << 30, INT32_MAX}) {
    EXPECT_NEAR(to_host(along_x(raw)).x, 1.0, 0x1p-28) << raw;
    EXPECT_NEAR(to_host(along_x(-raw)).x, -1.0, 0x1p-28) << raw;
    EXPECT_EQ(along_x(raw).y, FixedUnit(0));
  }
  EXPECT_EQ(normalize(Vec3<FixedLength>(0)), Vec3<FixedUnit>(0));
  EXPECT_EQ(length(Vec3<FixedLength>(0)), FixedLength(0));
  EXPECT_EQ(length(Vec3<FixedLength>(FixedLength(0), FixedLength::from_raw(-1), FixedLength(0))).raw, 1);
  const FixedLength most = FixedLength::from_raw(INT32_MAX);
  EXPECT_EQ(length(Vec3<FixedLength>(most, FixedLength(4), FixedLength(0))), most) << "saturates";
}

}  // namespace
}  // namespace vitrine
