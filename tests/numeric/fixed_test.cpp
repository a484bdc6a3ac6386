// The operators of Fixed against exact arithmetic: values are compared as long doubles, which hold every
// 64-bit integer.
#include "numeric/fixed.h"

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

using Unit = FixedUnit;
using Length = FixedLength;
using Area = Fixed<2 * kLengthBits, std::int64_t>;

constexpr int kPairs = 1000000;
constexpr long double kUnitStep = 0x1p-29L;
constexpr long double kLengthStep = 0x1p-28L;

template <int B, class Rep>
long double exact(Fixed<B, Rep> x) {
  return std::ldexp(static_cast<long double>(x.raw), -B);
}

// Any size down to the last digit, either sign, below 2^bits.
std::int32_t random_raw(RandomInputs& random, int bits) {
  const auto magnitude =
      static_cast<std::int32_t>(random.bits() >> (64 - bits)) >> random.index(static_cast<std::size_t>(bits));
  return (random.bits() & 1U) != 0 ? -magnitude : magnitude;
}
Unit random_unit(RandomInputs& random, int bits = 31) { return Unit::from_raw(random_raw(random, bits)); }
Length random_length(RandomInputs& random, int bits = 31) {
  return Length::from_raw(random_raw(random, bits));
}

TEST(FixedTest, ConstantsAreTheNearest) {
  EXPECT_EQ(Unit(1).raw, 1 << 29);
  EXPECT_EQ(Unit(-4.0).raw, INT32_MIN);
  EXPECT_EQ(Unit(0x1p-30).raw, 1);
  EXPECT_EQ(Unit(-0x1p-30).raw, -1);
  EXPECT_EQ(Unit(0x1p-31).raw, 0);
  EXPECT_EQ(Length(7).raw, 7 << 28);
  EXPECT_EQ(Area(100.0).raw, std::int64_t{100} << 56);
}

TEST(FixedTest, SumsAndOrderAreThoseOfIntegers) {
  RandomInputs random(1);
  for (int i = 0; i < 1000; ++i) {
    const Unit a = random_unit(random, 30);
    const Unit b = random_unit(random, 30);
    EXPECT_EQ(exact(a + b), exact(a) + exact(b));
    EXPECT_EQ(exact(a - b), exact(a) - exact(b));
    EXPECT_EQ(exact(-a), -exact(a));
    EXPECT_EQ(exact(abs(a)), std::abs(exact(a)));
    EXPECT_EQ(a < b, exact(a) < exact(b));
    EXPECT_EQ(a == b, exact(a) == exact(b));
    Unit sum = a;
    sum += b;
    sum -= b;
    EXPECT_EQ(sum, a);
  }
}

TEST(FixedTest, ProductsAreTheNearest) {
  RandomInputs random(2);
  for (int i = 0; i < kPairs; ++i) {
    const Unit a = random_unit(random, 30);
    const Unit b = random_unit(random, 30);
    ASSERT_LE(std::abs(exact(a * b) - exact(a) * exact(b)), kUnitStep / 2) << a.raw << ' ' << b.raw;
    const Length c = random_length(random, 30);
    ASSERT_LE(std::abs(exact(c * b) - exact(c) * exact(b)), kLengthStep / 2) << c.raw << ' ' << b.raw;
    ASSERT_EQ(b * c, c * b);
  }
}

TEST(FixedTest, ProductsDoNotLean) {
  RandomInputs random(3);
  long double sum = 0.0L;
  for (int i = 0; i < kPairs; ++i) {
    const Unit a = random_unit(random, 30);
    const Unit b = Unit::from_raw(static_cast<std::int32_t>(random.bits() >> 35));
    sum += exact(a * b) - exact(a) * exact(b);
  }
  // the mean of uniform roundings, at four standard deviations
  EXPECT_LT(std::abs(sum / kPairs), 4.0L * kUnitStep / std::sqrt(12.0L * kPairs));
}

TEST(FixedTest, AreasAndSquaresAreExact) {
  RandomInputs random(4);
  for (int i = 0; i < 1000; ++i) {
    const Length a = random_length(random);
    const Length b = random_length(random);
    EXPECT_EQ(exact(a * b), exact(a) * exact(b));
    const Unit c = random_unit(random);
    EXPECT_EQ(exact(square(c)), exact(c) * exact(c));
  }
  EXPECT_EQ(exact(Length::from_raw(INT32_MIN) * Length::from_raw(INT32_MIN)), 64.0L);
  EXPECT_EQ(exact(square(Unit::from_raw(INT32_MIN))), 16.0L);
}

// The reciprocal's 2^-30 and as much again for the digit that is dropped from it, and half a step of
// rounding.
TEST(FixedTest, QuotientsAreWithinTheReciprocal) {
  RandomInputs random(5);
  for (int i = 0; i < kPairs; ++i) {
    const Unit a = random_unit(random);
    const Unit b = random_unit(random);
    if (b.raw == 0) continue;
    const long double quotient = exact(a) / exact(b);
    if (std::abs(quotient) > 3.9999L) continue;
    ASSERT_LE(std::abs(exact(a / b) - quotient), std::abs(quotient) * 0x1p-29L + kUnitStep / 2)
        << a.raw << ' ' << b.raw;
  }
}

TEST(FixedTest, QuotientsSaturate) {
  const Unit most = Unit::from_raw(INT32_MAX);
  EXPECT_EQ(Unit(1) / Unit(0), most);
  EXPECT_EQ(Unit(0) / Unit(0), most);
  EXPECT_EQ(Unit(-1) / Unit(0), -most);
  EXPECT_EQ(Unit(1) / Unit(0.125), most);
  EXPECT_EQ(Unit(-1) / Unit(0.125), -most);
  EXPECT_EQ(Unit(1) / Unit(-0.125), -most);
  EXPECT_EQ(Unit(-1) / Unit(-0.125), most);
  EXPECT_EQ(Unit(3) / Unit::from_raw(1), most);
  EXPECT_EQ(Unit::from_raw(INT32_MIN) / Unit::from_raw(1), -most);
  EXPECT_EQ(Unit(0) / Unit(3), Unit(0));
  EXPECT_NEAR(static_cast<double>(exact(Unit(-4.0) / Unit(-4.0))), 1.0, 0x1p-29);
  EXPECT_NEAR(static_cast<double>(exact(Unit(1) / Unit(-4.0))), -0.25, 0x1p-29);
}

TEST(FixedTest, QuotientsOfAreas) {
  RandomInputs random(6);
  for (int i = 0; i < kPairs; ++i) {
    const Area a = random_length(random) * random_length(random);
    const Area b = random_length(random) * random_length(random);
    const bool swap = std::abs(exact(a)) > std::abs(exact(b));
    const Area& small = swap ? b : a;
    const Area& large = swap ? a : b;
    if (large.raw == 0) continue;
    ASSERT_NEAR(static_cast<double>(exact(small / large)), static_cast<double>(exact(small) / exact(large)),
                0x1p-28)
        << small.raw << ' ' << large.raw;
  }
  EXPECT_EQ(Area::from_raw(0) / Area::from_raw(-1), Unit(0));
  EXPECT_EQ(Area::from_raw(INT64_MIN) / Area::from_raw(INT64_MIN), Unit(1));
  EXPECT_EQ(Area::from_raw(-1) / Area::from_raw(1), Unit(-1));
}

// The reciprocal root's 2^-29, and half a step of rounding.
TEST(FixedTest, SquareRoots) {
  const auto check = [](std::int32_t raw) {
    const Unit x = Unit::from_raw(raw);
    const long double root = std::sqrt(exact(x));
    ASSERT_LE(std::abs(exact(sqrt(x)) - root), root * 0x1p-29L + kUnitStep / 2) << raw;
  };
  for (std::int64_t raw = 0; raw <= INT32_MAX; raw += 1999) check(static_cast<std::int32_t>(raw));
  for (std::int32_t raw = 0; raw < 100000; ++raw) check(raw);
  for (int bit = 2; bit < 31; ++bit) {
    for (int near = -2; near <= 2; ++near) check(static_cast<std::int32_t>((std::int64_t{1} << bit) + near));
  }
  check(INT32_MAX);
  EXPECT_EQ(sqrt(Unit(0)), Unit(0));
  EXPECT_EQ(sqrt(Unit(-1)), Unit(0));
  EXPECT_EQ(sqrt(Unit::from_raw(INT32_MIN)), Unit(0));
}

TEST(FixedTest, OtherFormatsRoundToNearest) {
  EXPECT_EQ(Unit(Length::from_raw(3)).raw, 6);
  EXPECT_EQ(Length(Unit::from_raw(5)).raw, 3);  // a half goes up
  EXPECT_EQ(Length(Unit::from_raw(-5)).raw, -2);
  RandomInputs random(7);
  for (int i = 0; i < 1000; ++i) {
    const Area area = random_length(random, 30) * random_length(random, 30);
    ASSERT_LE(std::abs(exact(Fixed<20>(area)) - exact(area)), 0x1p-21L);
    const Unit unit = random_unit(random);
    ASSERT_EQ(exact(Fixed<2 * kUnitBits, std::int64_t>(unit)), exact(unit));
  }
}

TEST(FixedTest, InverseOfADirection) {
  RandomInputs random(8);
  for (int i = 0; i < kPairs; ++i) {
    const Unit d = random_unit(random, 30);
    if (d.raw == 0) continue;
    const FixedInverse inverse(d);
    const long double value = std::ldexp(static_cast<long double>(inverse.mantissa), -inverse.shift);
    ASSERT_LE(std::abs(value * exact(d) - 1.0L), 0x1p-29L) << d.raw;  // a digit less than the reciprocal
    const Length a = random_length(random, 30);
    const long double exact_distance = exact(a) / exact(d);
    const long double distance = exact(a * inverse);
    if (std::abs(exact_distance) < 7.9999L) {
      ASSERT_LE(std::abs(distance - exact_distance), std::abs(exact_distance) * 0x1p-29L + kLengthStep)
          << d.raw;
    } else {
      ASSERT_GE(std::abs(distance), 7.999L);
      ASSERT_EQ(distance < 0, exact_distance < 0);
    }
  }
  EXPECT_EQ(Length(0.001) * FixedInverse(Unit(0)), Length::from_raw(INT32_MAX));
  EXPECT_EQ(Length(-0.001) * FixedInverse(Unit(0)), Length::from_raw(-INT32_MAX));
}

}  // namespace
}  // namespace vitrine
