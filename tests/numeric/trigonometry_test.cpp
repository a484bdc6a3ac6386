#include "numeric/trigonometry.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/host_conversion.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

template <class N>
class TrigonometryTest : public testing::Test {};
TYPED_TEST_SUITE(TrigonometryTest, NumberSystems, NumberSystemNames);

// The polynomial's 7e-9, and some roundings of the type.
TYPED_TEST(TrigonometryTest, SineAndCosineOfTurns) {
  using Unit = typename TypeParam::Unit;
  double worst = 0.0;
  for (std::uint64_t bits = 0; bits >> 32 == 0; bits += 4001) {
    const Unit turns = TypeParam::unit_from_bits(static_cast<std::uint32_t>(bits));
    const double angle = to_host(turns) * 2.0 * std::numbers::pi;
    const SinCos<Unit> result = sincos_turns(turns);
    worst = std::max({worst, std::abs(to_host(result.sin) - std::sin(angle)),
                      std::abs(to_host(result.cos) - std::cos(angle))});
  }
  EXPECT_LE(worst, 7e-9 + bound<TypeParam>(4 * 0x1p-24, 3 * 0x1p-30));
}

TYPED_TEST(TrigonometryTest, QuarterTurns) {
  using Unit = typename TypeParam::Unit;
  const double tolerance = 7e-9 + bound<TypeParam>(0x1p-23, 0x1p-29);
  const double sines[] = {0.0, 1.0, 0.0, -1.0};
  for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
    const SinCos<Unit> result = sincos_turns(TypeParam::unit_from_bits(quarter << 30));
    EXPECT_NEAR(to_host(result.sin), sines[quarter], tolerance);
    EXPECT_NEAR(to_host(result.cos), sines[(quarter + 1) % 4], tolerance);
  }
}

double exact_turns(double y, double x) { return std::atan2(y, x) / (2.0 * std::numbers::pi); }

TYPED_TEST(TrigonometryTest, ArcTangentAllAround) {
  using Unit = typename TypeParam::Unit;
  RandomInputs random(1);
  double worst = 0.0;
  for (int i = 0; i < 300000; ++i) {
    const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
    const double radius = random.uniform(0.5, 1.9);
    const auto x = from_host<Unit>(radius * std::cos(angle));
    const auto y = from_host<Unit>(radius * std::sin(angle));
    worst = std::max(worst, std::abs(to_host(atan2_turns(y, x)) - exact_turns(to_host(y), to_host(x))));
  }
  EXPECT_LE(worst, 4e-11 + bound<TypeParam>(3 * 0x1p-26, 4 * 0x1p-30));
}

// Slopes from a Unit's resolution on keep their digits: the error is relative, in float, or a rounding.
TYPED_TEST(TrigonometryTest, ArcTangentOfSmallSlopes) {
  using Unit = typename TypeParam::Unit;
  RandomInputs random(2);
  for (int i = 0; i < 100000; ++i) {
    const auto y = from_host<Unit>(random.log_uniform(1e-8, 1.0));
    const auto x = from_host<Unit>(random.uniform(0.9, 1.0));
    const double exact = exact_turns(to_host(y), to_host(x));
    ASSERT_NEAR(to_host(atan2_turns(y, x)), exact, bound<TypeParam>(4e-7 * exact, 3 * 0x1p-30));
  }
}

TYPED_TEST(TrigonometryTest, ArcTangentOnTheAxesAndDiagonals) {
  using Unit = typename TypeParam::Unit;
  const double tolerance = bound<TypeParam>(0x1p-25, 0x1p-29);
  for (const double y : {-1.0, 0.0, 1.0}) {
    for (const double x : {-1.0, 0.0, 1.0}) {
      const double exact = y == 0.0 && x == 0.0 ? 0.0 : exact_turns(y, x);
      EXPECT_NEAR(to_host(atan2_turns(from_host<Unit>(y), from_host<Unit>(x))), exact, tolerance) << y << x;
    }
  }
}

}  // namespace
}  // namespace vitrine
