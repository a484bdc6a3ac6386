// What is true of the points without any chance, counted: matrices against their definition, and nets, those
// of sobol.h, those of the screen (screen_sobol.h) and the strata (strata.h); and that scrambling
// (owen_scramble.h) respects them.
#include "sampling/sobol.h"

#include <array>
#include <bit>
#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "sampling/owen_scramble.h"
#include "sampling/screen_sobol.h"
#include "sampling/split_mix.h"
#include "sampling/strata.h"
#include "statistics/chi_square.h"

namespace vitrine {
namespace {

using Point = std::array<std::uint32_t, 4>;  // fractions of 2^32

std::uint32_t leading(std::uint32_t x, std::uint32_t bits) { return bits == 0 ? 0 : x >> (32 - bits); }
std::uint32_t seed(std::uint32_t i) { return static_cast<std::uint32_t>(split_mix(i + 1) >> 32); }

// Whether every box of the unit square that has the size of one point, and sides of powers of `base_bits`
// bits, has one point.
bool is_net(const std::vector<Point>& points, std::size_t axis, std::uint32_t base_bits) {
  const auto size = static_cast<std::uint32_t>(std::bit_width(points.size()) - 1);
  for (std::uint32_t wide = 0; wide <= size; wide += base_bits) {
    std::vector<bool> seen(points.size(), false);
    for (const Point& p : points) {
      const std::uint32_t box = leading(p[axis], wide) << (size - wide) | leading(p[axis + 1], size - wide);
      if (seen[box]) return false;
      seen[box] = true;
    }
  }
  return true;
}

// The same in four dimensions and base 4.
bool is_net_4d(const std::vector<Point>& points) {
  const auto digits = static_cast<std::uint32_t>(std::bit_width(points.size()) - 1) / 2;
  for (std::uint32_t a = 0; a <= digits; ++a) {
    for (std::uint32_t b = 0; a + b <= digits; ++b) {
      for (std::uint32_t c = 0; a + b + c <= digits; ++c) {
        const std::uint32_t d = digits - a - b - c;
        std::set<std::uint32_t> boxes;
        for (const Point& p : points) {
          const std::uint32_t ab = leading(p[0], 2 * a) << 2 * b | leading(p[1], 2 * b);
          const std::uint32_t cd = leading(p[2], 2 * c) << 2 * d | leading(p[3], 2 * d);
          boxes.insert(ab << 2 * (c + d) | cd);
        }
        if (boxes.size() != points.size()) return false;
      }
    }
  }
  return true;
}

bool binomial_is_odd(std::uint32_t n, std::uint32_t k) {
  std::vector<bool> row{true};
  for (std::uint32_t i = 0; i < n; ++i) {
    row.push_back(true);
    for (std::size_t j = row.size() - 2; j > 0; --j) row[j] = row[j] != row[j - 1];
  }
  return k <= n && row[k];
}

TEST(SobolTest, DigitsAreAField) {
  for (std::uint32_t digit = 0; digit < 4; ++digit) {
    EXPECT_EQ(times_w(times_w(digit)), times_w2(digit));
    EXPECT_EQ(times_w(times_w2(digit)), digit);
    EXPECT_EQ(times_w2(digit), times_w(digit) ^ digit);
    EXPECT_EQ(times_w(digit << 30), times_w(digit) << 30);
  }
  EXPECT_EQ(std::set({1U, times_w(1), times_w2(1)}).size(), 3U);
}

TEST(SobolTest, MatricesHaveTheirEntries) {
  for (std::uint32_t column = 0; column < 32; ++column) {
    for (std::uint32_t row = 0; row < 32; ++row) {
      EXPECT_EQ(pascal(1U << column) >> row & 1U, binomial_is_odd(column, row)) << row << ' ' << column;
    }
  }
  for (std::uint32_t column = 0; column < 16; ++column) {
    for (std::uint32_t digit = 1; digit < 4; ++digit) {
      for (std::uint32_t row = 0; row < 16; ++row) {
        std::uint32_t expected = binomial_is_odd(column, row) ? digit : 0;
        for (std::uint32_t i = row; i < column; ++i) expected = times_w(expected);
        EXPECT_EQ(pascal_w(digit << 2 * column) >> 2 * row & 3U, expected) << row << ' ' << column;
      }
    }
  }
}

TEST(SobolTest, MatricesAreLinearAndTheirOwnInverse) {
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const std::uint32_t x = seed(i);
    const std::uint32_t y = seed(i + 1000);
    EXPECT_EQ(pascal(x ^ y), pascal(x) ^ pascal(y));
    EXPECT_EQ(pascal_w(x ^ y), pascal_w(x) ^ pascal_w(y));
    EXPECT_EQ(pascal(pascal(x)), x);
    EXPECT_EQ(pascal_w(pascal_w(x)), x);
  }
}

// The i-th scrambled sobol() point, each coordinate by its own seed; seed 0 does not scramble.
Point sobol_point(std::uint32_t i, std::uint32_t scrambling) {
  Point p{};
  for (std::uint32_t c = 0; c < 4; ++c) {
    p[c] = reverse_bits(sobol(i, c));
    if (scrambling != 0) p[c] = owen_scramble(p[c], seed(scrambling * 4 + c));
  }
  return p;
}

TEST(SobolTest, AlignedBlocksAreNets) {
  for (const std::uint32_t scrambling : {0U, 1U, 2U}) {
    for (std::uint32_t m = 0; m <= 10; ++m) {
      for (const std::uint32_t block : {0U, 1U, 2U, 5U, 1000U}) {
        std::vector<Point> points;
        for (std::uint32_t i = 0; i < 1U << m; ++i)
          points.push_back(sobol_point((block << m) + i, scrambling));
        EXPECT_TRUE(is_net(points, 0, 1)) << block << " of 2^" << m;
        EXPECT_TRUE(is_net(points, 2, 1)) << block << " of 2^" << m;
        EXPECT_TRUE(m % 2 == 1 || is_net_4d(points)) << block << " of 2^" << m;
      }
    }
  }
}

TEST(OwenScrambleTest, BitsDependOnThoseAboveOnly) {
  for (std::uint32_t s = 0; s < 50; ++s) {
    for (std::uint32_t bits = 1; bits <= 31; ++bits) {
      const std::uint32_t x = seed(100 + s);
      const std::uint32_t below = seed(200 + s) >> bits;
      EXPECT_EQ(leading(owen_scramble(x, seed(s)), bits), leading(owen_scramble(x ^ below, seed(s)), bits));
      const std::uint32_t sibling = x ^ 1U << (32 - bits);
      EXPECT_NE(leading(owen_scramble(x, seed(s)), bits), leading(owen_scramble(sibling, seed(s)), bits));
    }
  }
}

// A point becomes any point, and two points become any two as far as their common leading bits allow.
TEST(OwenScrambleTest, EveryOutcomeIsAsLikely) {
  constexpr int kComparisons = 5 * 3;
  for (const std::uint32_t x : {0U, 1U, 0x80000000U, 0xffffffffU, 0x12345678U}) {
    std::vector<std::uint64_t> leading_bits(256, 0);
    std::vector<std::uint64_t> last_bits(256, 0);
    std::vector<std::uint64_t> flips(256, 0);
    for (std::uint32_t s = 0; s < 100000; ++s) {
      const std::uint32_t y = owen_scramble(x, seed(s));
      ++leading_bits[y >> 24];
      ++last_bits[y & 255U];
      // Bits 1 to 8 of two points that differ in the first bit are flipped independently.
      const std::uint32_t other = owen_scramble(x ^ 0x80000000U, seed(s));
      ++flips[(y ^ other) >> 23 & 255U];
    }
    EXPECT_GT(chi_square_uniform(leading_bits).p_value, sidak(kComparisons)) << x;
    EXPECT_GT(chi_square_uniform(last_bits).p_value, sidak(kComparisons)) << x;
    EXPECT_GT(chi_square_uniform(flips).p_value, sidak(kComparisons)) << x;
  }
}

TEST(ScreenSobolTest, ZOrderIsOfSquaresInSquares) {
  for (std::uint32_t bits = 1; bits <= 6; ++bits) {  // squares of 2^bits pixels a side
    std::set<std::uint32_t> pixels;
    std::set<std::uint32_t> squares;
    for (std::uint32_t y = 0; y < 64; ++y) {
      for (std::uint32_t x = 0; x < 64; ++x) {
        const std::uint32_t order = z_order(x + 1024, y + 64, seed(1));
        pixels.insert(order);
        const std::uint32_t coarse = order << 2 * bits;
        squares.insert(coarse);
        const std::uint32_t side = 1U << bits;
        EXPECT_EQ(coarse, z_order(x / side * side + 1024, y / side * side + 64, seed(1)) << 2 * bits);
      }
    }
    EXPECT_EQ(pixels.size(), 64U * 64U);
    EXPECT_EQ(squares.size(), (64U >> bits) * (64U >> bits));
  }
}

std::vector<Point> square_of_pixels(std::uint32_t first_x, std::uint32_t side, std::uint32_t samples) {
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const std::uint32_t order = z_order(first_x + i % side, 2 * side + i / side, seed(3));
    const std::uint32_t other = owen_scramble_reversed(order, seed(4));
    for (std::uint32_t s = 0; s < samples; ++s) {
      const std::uint32_t sample = owen_scramble(reorder_within_octaves(s, seed(order)), seed(5));
      Point p{};
      for (std::uint32_t c = 0; c < 4; ++c)
        p[c] = reverse_bits(screen_sobol(c < 2 ? order : other, sample, c));
      points.push_back(p);
    }
  }
  return points;
}

TEST(ScreenSobolTest, EveryPixelHasNets) {
  for (std::uint32_t m = 0; m <= 8; ++m) {
    for (const std::uint32_t x : {0U, 1U, 7U, 1000U}) {
      const std::vector<Point> points = square_of_pixels(x, 1, 1U << m);
      EXPECT_TRUE(is_net(points, 0, 1)) << x << ": 2^" << m;
      EXPECT_TRUE(is_net(points, 2, 1)) << x << ": 2^" << m;
      EXPECT_TRUE(m % 2 == 1 || is_net_4d(points)) << x << ": 2^" << m;
    }
  }
}

TEST(ScreenSobolTest, EverySquareOfPixelsHasNets) {
  for (const std::uint32_t side : {2U, 4U, 8U}) {
    for (const std::uint32_t samples : {1U, 4U, 16U, 64U}) {
      for (const std::uint32_t square : {0U, 1U, 6U}) {
        const std::vector<Point> points = square_of_pixels(square * side, side, samples);
        EXPECT_TRUE(is_net(points, 0, 2)) << side << ' ' << samples << ' ' << square;
        EXPECT_TRUE(is_net(points, 2, 2)) << side << ' ' << samples << ' ' << square;
      }
    }
  }
}

TEST(ScreenSobolTest, OctavesStay) {
  for (std::uint32_t s = 0; s < 20; ++s) {
    EXPECT_EQ(reorder_within_octaves(0, seed(s)), 0U);
    for (std::uint32_t first = 1; first <= 256; first *= 2) {
      std::set<std::uint32_t> samples;
      for (std::uint32_t i = first; i < 2 * first; ++i) samples.insert(reorder_within_octaves(i, seed(s)));
      EXPECT_EQ(samples.size(), first);
      EXPECT_EQ(*samples.begin(), first);
      EXPECT_EQ(*samples.rbegin(), 2 * first - 1);
    }
  }
}

// A block's cells, in Z order, are each in another of as many equal parts.
TEST(StrataTest, AlignedBlocksAreInAsManyParts) {
  for (std::uint32_t s = 0; s < 100; ++s) {
    for (std::uint32_t bits = 0; bits <= 6; ++bits) {
      for (std::uint32_t first = 0; first < kStrata; first += 1U << bits) {
        std::set<std::uint32_t> parts;
        for (std::uint32_t i = first; i < first + (1U << bits); ++i) {
          const std::uint32_t column = stratum(i, 0, seed(s), seed(s + 100));
          const std::uint32_t row = stratum(i, 1, seed(s), seed(s + 100));
          ASSERT_LT(column, 8U);
          ASSERT_LT(row, 8U);
          parts.insert(column >> (3 - (bits + 1) / 2) << 3 | row >> (3 - bits / 2));
        }
        EXPECT_EQ(parts.size(), 1U << bits);
      }
    }
  }
}

}  // namespace
}  // namespace vitrine
