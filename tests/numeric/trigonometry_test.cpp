#include "numeric/trigonometry.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/host_conversion.h"

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

}  // namespace
}  // namespace vitrine
