#include "numeric/wide.h"

#include <cmath>

#include <gtest/gtest.h>

#include "numeric/host_conversion.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

constexpr int kPairs = 1000000;

long double exact(Wide x) { return std::ldexp(static_cast<long double>(x.mantissa), x.exponent); }

Wide random_wide(RandomInputs& random, int exponents = 60) {
  const auto exponent =
      static_cast<std::int32_t>(random.index(static_cast<std::size_t>(exponents))) - exponents / 2;
  return Wide::normalized(random.bits() | 1U, exponent - 63);
}

bool is_normal(Wide x) { return x.mantissa >= (1U << 31); }

TEST(WideTest, Constants) {
  EXPECT_EQ(Wide(1).mantissa, 1U << 31);
  EXPECT_EQ(Wide(1).exponent, -31);
  EXPECT_EQ(exact(Wide(3)), 3.0L);
  EXPECT_EQ(exact(Wide(0x1p200)), 0x1p200L);
  EXPECT_EQ(exact(Wide(0x1.8p-200)), 0x1.8p-200L);
  EXPECT_EQ(Wide(0), Wide::zero());
  EXPECT_NEAR(static_cast<double>(exact(Wide(0.1))), 0.1, 0.1 * 0x1p-31);
}

TEST(WideTest, OrderIsThatOfValues) {
  RandomInputs random(1);
  for (int i = 0; i < 10000; ++i) {
    const Wide a = random_wide(random, 4);
    const Wide b = random_wide(random, 4);
    EXPECT_EQ(a < b, exact(a) < exact(b));
    EXPECT_EQ(a == b, exact(a) == exact(b));
    EXPECT_LT(Wide::zero(), a);
    EXPECT_LT(a, Wide::huge());
  }
  EXPECT_LT(Wide::zero(), Wide(1e-300));
}

TEST(WideTest, Products) {
  RandomInputs random(2);
  for (int i = 0; i < kPairs; ++i) {
    const Wide a = random_wide(random);
    const Wide b = random_wide(random);
    const Wide product = a * b;
    ASSERT_TRUE(is_normal(product));
    ASSERT_LE(std::abs(exact(product) / (exact(a) * exact(b)) - 1.0L), 0x1p-31L)
        << a.mantissa << ' ' << b.mantissa;
  }
  EXPECT_EQ(Wide::zero() * Wide(3), Wide::zero());
  EXPECT_EQ(Wide(3) * Wide::zero(), Wide::zero());
  EXPECT_EQ(Wide(1) * Wide(3), Wide(3));
}

TEST(WideTest, Quotients) {
  RandomInputs random(3);
  for (int i = 0; i < kPairs; ++i) {
    const Wide a = random_wide(random);
    const Wide b = random_wide(random);
    const Wide quotient = a / b;
    ASSERT_TRUE(is_normal(quotient));
    ASSERT_LE(std::abs(exact(quotient) / (exact(a) / exact(b)) - 1.0L), 0x1p-29L)
        << a.mantissa << ' ' << b.mantissa;
  }
  EXPECT_EQ(Wide::zero() / Wide(3), Wide::zero());
  EXPECT_EQ(Wide::zero() / Wide::zero(), Wide::zero());
}

TEST(WideTest, DivisionByZeroIsNotFiniteHoweverItGoesOn) {
  const Wide infinite = Wide(1) / Wide::zero();
  EXPECT_EQ(infinite, Wide::huge());
  EXPECT_FALSE(is_finite(infinite));
  EXPECT_FALSE(is_finite(infinite * Wide(1e-30)));
  EXPECT_FALSE(is_finite(infinite + Wide(1)));
  EXPECT_EQ(Wide(1) / infinite * FixedUnit(1) + Wide(1), Wide(1));
  EXPECT_TRUE(is_finite(Wide::zero()));
  EXPECT_TRUE(is_finite(Wide(1e300)));
}

TEST(WideTest, Sums) {
  RandomInputs random(4);
  for (int i = 0; i < kPairs; ++i) {
    const Wide a = random_wide(random);
    const Wide b = random_wide(random);
    const Wide sum = a + b;
    ASSERT_TRUE(is_normal(sum));
    ASSERT_EQ(sum, b + a);
    ASSERT_LE(std::abs(exact(sum) / (exact(a) + exact(b)) - 1.0L), 0x1p-30L)
        << a.mantissa << ' ' << b.mantissa;
  }
  EXPECT_EQ(Wide(3) + Wide::zero(), Wide(3));
  EXPECT_EQ(Wide::zero() + Wide::zero(), Wide::zero());
  EXPECT_EQ(Wide(1) + Wide(1), Wide(2));
  EXPECT_EQ(Wide(1) + Wide(1e-30), Wide(1));
}

TEST(WideTest, ComesFromFixedWithoutLoss) {
  RandomInputs random(5);
  for (int i = 0; i < 10000; ++i) {
    const auto unit = FixedUnit::from_raw(static_cast<std::int32_t>(random.bits() >> 33 >> random.index(31)));
    EXPECT_EQ(exact(Wide(unit)), static_cast<long double>(to_host(unit)));
    const FixedLength length(unit);
    EXPECT_LE(std::abs(exact(Wide(length * length)) - static_cast<long double>(to_host(length * length))),
              static_cast<long double>(to_host(length * length)) * 0x1p-31L);
  }
  EXPECT_EQ(Wide(FixedUnit(0)), Wide::zero());
  EXPECT_EQ(Wide(FixedUnit(-1)), Wide::zero());
}

TEST(WideTest, BecomesTheNearestFixed) {
  RandomInputs random(6);
  for (int i = 0; i < 100000; ++i) {
    const Wide x = random_wide(random, 64) * Wide(0x1p-30);
    if (exact(x) < 3.9999L) {
      ASSERT_LE(std::abs(static_cast<long double>(to_host(FixedUnit(x))) - exact(x)), 0x1p-30L) << x.exponent;
    }
  }
  EXPECT_EQ(FixedUnit(Wide(4)).raw, INT32_MAX);
  EXPECT_EQ(FixedUnit(Wide(3.9999999999)).raw, INT32_MAX);
  EXPECT_EQ(FixedUnit(Wide::huge()).raw, INT32_MAX);
  EXPECT_EQ(FixedUnit(Wide::zero()).raw, 0);
  EXPECT_EQ(FixedUnit(Wide(0x1p-30)).raw, 1);
  EXPECT_EQ(FixedUnit(Wide(0x0.fffp-30)).raw, 0);
  EXPECT_EQ(FixedUnit(Wide(1e-300)).raw, 0);
}

TEST(WideTest, ExcessIsADifferenceThatStopsAtZero) {
  RandomInputs random(11);
  for (int i = 0; i < 100000; ++i) {
    const Wide a = random_wide(random, 8);
    const Wide b = random_wide(random, 8);
    const long double expected = exact(a) > exact(b) ? exact(a) - exact(b) : 0.0L;
    ASSERT_LE(std::abs(exact(excess(a, b)) - expected), 0x1p-30L * exact(a));
  }
  EXPECT_EQ(excess(Wide(3), Wide(1)), Wide(2));
  EXPECT_EQ(excess(Wide(1), Wide(3)), Wide::zero());
  EXPECT_EQ(excess(Wide(3), Wide(3)), Wide::zero());
  EXPECT_EQ(excess(Wide(3), Wide::zero()), Wide(3));
  EXPECT_EQ(excess(Wide(1), Wide(0x1p-40)), Wide(1));
}

TEST(WideTest, SquareRoots) {
  RandomInputs random(12);
  for (int i = 0; i < 100000; ++i) {
    const Wide x = random_wide(random);
    const Wide root = sqrt(x);
    ASSERT_TRUE(is_normal(root));
    ASSERT_LE(std::abs(exact(root) / std::sqrt(exact(x)) - 1.0L), 0x1p-29L)
        << x.mantissa << ' ' << x.exponent;
  }
  EXPECT_EQ(sqrt(Wide::zero()), Wide::zero());
  EXPECT_NEAR(static_cast<double>(exact(sqrt(Wide(16)))), 4.0, 4.0 * 0x1p-29);
}

}  // namespace
}  // namespace vitrine
