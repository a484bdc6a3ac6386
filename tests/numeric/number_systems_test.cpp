// What a number system says beside its types: both answer every question alike.
#include "number_systems.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "numeric/host_conversion.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

constexpr int kValues = 100000;
constexpr int kBits = 36;  // of a film value
constexpr std::int64_t kLimit = std::int64_t{1} << 56;

template <class N>
class NumberSystemsTest : public testing::Test {};
TYPED_TEST_SUITE(NumberSystemsTest, NumberSystems, NumberSystemNames);

TYPED_TEST(NumberSystemsTest, RandomBitsBecomeFractions) {
  RandomInputs random(1);
  const double step = bound<TypeParam>(0x1p-24, 0x1p-29);
  for (int i = 0; i < kValues; ++i) {
    const auto bits = static_cast<std::uint32_t>(random.bits());
    const double x = to_host(TypeParam::unit_from_bits(bits));
    ASSERT_EQ(x, std::floor(bits * 0x1p-32 / step) * step) << "exactly the leading digits";
  }
  EXPECT_EQ(to_host(TypeParam::unit_from_bits(0)), 0.0);
  EXPECT_EQ(to_host(TypeParam::unit_from_bits(0xffffffffU)), 1.0 - step);
}

TYPED_TEST(NumberSystemsTest, PixelCoordinates) {
  using Unit = typename TypeParam::Unit;
  RandomInputs random(2);
  for (const std::uint32_t count : {1U, 3U, 512U, 1920U, 32768U}) {
    const auto step = TypeParam::pixel_step(count);
    for (int i = 0; i < kValues / 10; ++i) {
      const std::uint32_t index = random.index(count);
      const Unit u = TypeParam::unit_from_bits(static_cast<std::uint32_t>(random.bits()));
      // in fixed point u counts to 2^-16 of a pixel
      ASSERT_NEAR(to_host(TypeParam::pixel_coordinate(index, u, step)), (index + to_host(u)) / count,
                  bound<TypeParam>(0x1p-22, 0x1p-16 / count + 0x1p-29));
    }
    EXPECT_EQ(to_host(TypeParam::pixel_coordinate(0, Unit(0), step)), 0.0);
    EXPECT_LE(to_host(TypeParam::pixel_coordinate(count - 1, TypeParam::unit_from_bits(0xffffffffU), step)),
              1.0);
  }
}

TYPED_TEST(NumberSystemsTest, InverseOfADirection) {
  using Unit = typename TypeParam::Unit;
  using Length = typename TypeParam::Length;
  RandomInputs random(3);
  const auto distance = [](double length, Unit d) {
    return to_host(from_host<Length>(length) * TypeParam::inverse(d));
  };
  for (int i = 0; i < kValues; ++i) {
    const auto d = from_host<Unit>(random.log_uniform(0.2, 1.0) * (i % 2 == 0 ? 1.0 : -1.0));
    const double length = random.uniform(-1.0, 1.0);
    const double exact = to_host(from_host<Length>(length)) / to_host(d);
    ASSERT_NEAR(distance(length, d), exact, bound<TypeParam>(0x1p-22 * std::abs(exact), 0x1p-26));
  }
  // Along no axis at all, whatever lies aside is beyond every hit.
  EXPECT_GT(distance(1e-5, Unit(0)), 7.0);
  EXPECT_LT(distance(-1e-5, Unit(0)), -7.0);
  EXPECT_EQ(distance(0.0, Unit(0)), 0.0);
  EXPECT_GT(distance(1e-5, -Unit(0)), 7.0) << "minus zero is no negative direction";
}

TYPED_TEST(NumberSystemsTest, Cells) {
  using TexCoord = typename TypeParam::TexCoord;
  RandomInputs random(4);
  for (int i = 0; i < kValues; ++i) {
    const auto x = from_host<TexCoord>(random.uniform(-100.0, 100.0));
    const auto cell = TypeParam::cell(x);
    ASSERT_EQ(cell.index, static_cast<int>(std::floor(to_host(x))));
    ASSERT_NEAR(to_host(cell.fraction), to_host(x) - cell.index, bound<TypeParam>(0x1p-25, 0.0));
  }
  const auto below_zero = TypeParam::cell(TexCoord(-0.25));
  EXPECT_EQ(below_zero.index, -1);
  EXPECT_EQ(to_host(below_zero.fraction), 0.75);
  EXPECT_EQ(TypeParam::cell(TexCoord(3)).index, 3);
  EXPECT_EQ(TypeParam::cell(TexCoord(-3)).index, -3);
}

TYPED_TEST(NumberSystemsTest, Texels) {
  using Unit = typename TypeParam::Unit;
  RandomInputs random(5);
  for (const int size : {1, 2, 7, 256, 4096}) {
    for (int i = 0; i < kValues / 10; ++i) {
      const auto x = from_host<Unit>(random.uniform());
      const auto texel = TypeParam::texel(x, size);
      const double exact = to_host(x) * size - 0.5;
      ASSERT_NEAR(texel.index + to_host(texel.fraction), exact, bound<TypeParam>(size * 0x1p-23, 0.0));
      ASSERT_TRUE(texel.fraction >= 0 && texel.fraction < 1);
    }
    EXPECT_EQ(TypeParam::texel(Unit(0), size).index, -1);
    EXPECT_EQ(to_host(TypeParam::texel(Unit(0), size).fraction), 0.5);
    EXPECT_EQ(TypeParam::texel(Unit(1), size).index, size - 1);
  }
}

TYPED_TEST(NumberSystemsTest, QuantizeRounds) {
  using Unit = typename TypeParam::Unit;
  for (const int steps : {1, 31, 63, 255}) {
    for (int level = 0; level <= steps; ++level) {
      const auto at = [&](double offset) {
        return TypeParam::quantize(from_host<Unit>((level + offset) / steps), steps);
      };
      EXPECT_EQ(at(0.0), level);
      EXPECT_EQ(at(level < steps ? 0.499 : 0.0), level);
      EXPECT_EQ(at(level > 0 ? -0.499 : 0.0), level);
    }
  }
}

TYPED_TEST(NumberSystemsTest, FilmValuesRoundTrip) {
  using Radiance = typename TypeParam::Radiance;
  RandomInputs random(6);
  for (int i = 0; i < kValues; ++i) {
    const auto x = from_host<Radiance>(random.log_uniform(1e-12, 1e6));
    const auto stored = TypeParam::to_film(x, kBits, kLimit);
    ASSERT_TRUE(stored) << to_host(x);
    ASSERT_LE(std::abs(static_cast<double>(*stored) - std::ldexp(to_host(x), kBits)), 0.5);
    const double back = to_host(TypeParam::from_film(*stored, 1, kBits));
    ASSERT_NEAR(back, to_host(x), to_host(x) * bound<TypeParam>(0x1p-24, 0x1p-29) + std::ldexp(0.5, -kBits));
    const auto count = 1 + random.index(100000);
    const double mean = to_host(TypeParam::from_film(*stored, count, kBits));
    const double exact = std::ldexp(static_cast<double>(*stored) / count, -kBits);
    ASSERT_NEAR(mean, exact, exact * bound<TypeParam>(0x1p-24, 0x1p-28));
  }
  EXPECT_EQ(TypeParam::to_film(Radiance(0), kBits, kLimit), 0);
  EXPECT_EQ(to_host(TypeParam::from_film(0, 5, kBits)), 0.0);
  EXPECT_EQ(TypeParam::to_film(Radiance(1e-30), kBits, kLimit), 0);
}

TYPED_TEST(NumberSystemsTest, TheFilmRefusesTheNonFinite) {
  using Radiance = typename TypeParam::Radiance;
  const Radiance infinite = Radiance(1) / Radiance(0);
  EXPECT_FALSE(TypeParam::to_film(infinite, kBits, kLimit));
  EXPECT_FALSE(TypeParam::to_film(infinite + Radiance(1), kBits, kLimit));
  EXPECT_FALSE(TypeParam::to_film(Radiance(0x1p20), kBits, kLimit)) << "the limit itself";
  EXPECT_FALSE(TypeParam::to_film(Radiance(1e38), kBits, kLimit));
  EXPECT_TRUE(TypeParam::to_film(from_host<Radiance>(0x1p20 * (1.0 - 0x1p-20)), kBits, kLimit));
}

TEST(FloatNumbersTest, TheFilmRefusesNansAndNegatives) {
  EXPECT_FALSE(FloatNumbers::to_film(std::numeric_limits<float>::quiet_NaN(), kBits, kLimit));
  EXPECT_FALSE(FloatNumbers::to_film(-std::numeric_limits<float>::infinity(), kBits, kLimit));
  EXPECT_FALSE(FloatNumbers::to_film(-1.0F, kBits, kLimit));
}

TYPED_TEST(NumberSystemsTest, QuarterStops) {
  using Radiance = typename TypeParam::Radiance;
  RandomInputs random(7);
  for (int i = 0; i < kValues; ++i) {
    const auto x = from_host<Radiance>(random.log_uniform(1e-9, 1e9));
    const double stops = 4.0 * std::log2(to_host(x));
    if (std::abs(stops - std::round(stops)) < 1e-5) continue;  // either side may be right
    ASSERT_EQ(TypeParam::quarter_stop(x), static_cast<int>(std::floor(stops))) << to_host(x);
  }
  EXPECT_EQ(TypeParam::quarter_stop(Radiance(1)), 0);
  EXPECT_EQ(TypeParam::quarter_stop(Radiance(8)), 12);
  EXPECT_EQ(TypeParam::quarter_stop(Radiance(0.125)), -12);
}

}  // namespace
}  // namespace vitrine
