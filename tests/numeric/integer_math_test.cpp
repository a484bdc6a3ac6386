#include "numeric/integer_math.h"

#include <cmath>

#include <gtest/gtest.h>

namespace vitrine {
namespace {

constexpr std::uint64_t kEnd = std::uint64_t{1} << 32;

// Calls check(m) for millions of m in [begin, 2^32), and for all near the borders of the tables' entries.
template <class Check>
void for_mantissas(std::uint64_t begin, const Check& check) {
  for (std::uint64_t m = begin; m < kEnd; m += 997) check(static_cast<std::uint32_t>(m));
  for (std::uint64_t border = begin; border <= kEnd; border += std::uint64_t{1} << 22) {
    for (std::uint64_t m = border - 3; m < border + 3; ++m) {
      if (m >= begin && m < kEnd) check(static_cast<std::uint32_t>(m));
    }
  }
}

TEST(IntegerMathTest, Reciprocal) {
  double worst = 0.0;
  for_mantissas(kEnd / 2, [&](std::uint32_t m) {
    const std::uint32_t r = reciprocal_mantissa(m);
    ASSERT_TRUE(r >= (1U << 30) && r < (1U << 31)) << m;
    worst = std::max(worst, std::abs(static_cast<double>(r) * m * 0x1p-62 - 1.0));
  });
  EXPECT_LE(worst, 1.002 * 0x1p-30);
}

TEST(IntegerMathTest, ReciprocalSquareRoot) {
  double worst = 0.0;
  for_mantissas(kEnd / 4, [&](std::uint32_t m) {
    const std::uint32_t y = rsqrt_mantissa(m);
    ASSERT_TRUE(y >= (1U << 30) && y < (1U << 31)) << m;
    worst =
        std::max(worst, std::abs(static_cast<double>(y) * std::sqrt(static_cast<double>(m)) * 0x1p-46 - 1.0));
  });
  EXPECT_LE(worst, 0x1p-29);
}

TEST(IntegerMathTest, ShiftRounds) {
  EXPECT_EQ(shift_right_rounded(5, 1), 3);  // a half goes up
  EXPECT_EQ(shift_right_rounded(-5, 1), -2);
  EXPECT_EQ(shift_right_rounded(-6, 2), -1);
  EXPECT_EQ(shift_right_rounded(-7, 2), -2);
  EXPECT_EQ(shift_right_rounded(7, 0), 7);
  EXPECT_EQ(shift_right_rounded(7, -31), std::int64_t{7} << 31);
  EXPECT_EQ(shift_right_rounded(std::int64_t{1} << 61, 62), 1);
  EXPECT_EQ(shift_right_rounded((std::int64_t{1} << 61) - 1, 62), 0);
}

TEST(IntegerMathTest, Saturates) {
  EXPECT_EQ(saturate_i32(INT32_MAX), INT32_MAX);
  EXPECT_EQ(saturate_i32(std::int64_t{INT32_MAX} + 1), INT32_MAX);
  EXPECT_EQ(saturate_i32(INT64_MAX), INT32_MAX);
  EXPECT_EQ(saturate_i32(-INT32_MAX), -INT32_MAX);
  EXPECT_EQ(saturate_i32(INT64_MIN), -INT32_MAX);
}

}  // namespace
}  // namespace vitrine
