// Independent random numbers: those of one stream are uniform, and so are pairs: two dimensions of a sample,
// the same dimension of two samples, pixels or seeds that are neighbours. The other sequences:
// sequence_test.cpp.
#include "sampling/sampler.h"

#include <array>
#include <bit>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/host_conversion.h"
#include "statistics/chi_square.h"

namespace vitrine {
namespace {

constexpr std::uint32_t kDraws = 100000;
constexpr std::uint32_t kDimensions = 32;
constexpr int kComparisons = 2 * static_cast<int>(kDimensions) + 4 * 3;

Sampler random_sampler(std::uint64_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t sample) {
  return {Sequence::kRandom, seed, x, y, sample};
}

std::uint32_t dimension(Sampler sampler, std::uint32_t index) {
  for (std::uint32_t i = 0; i < index; ++i) sampler.next_bits();
  return sampler.next_bits();
}

// Whether pairs fill a grid of 16 x 16 cells evenly, by their leading and by their last digits.
template <class Pair>
void expect_independent(const Pair& pair) {
  std::vector<std::uint64_t> leading(256, 0);
  std::vector<std::uint64_t> last(256, 0);
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    const auto [a, b] = pair(i);
    ++leading[(a >> 28) * 16 + (b >> 28)];
    ++last[(a & 15U) * 16 + (b & 15U)];
  }
  EXPECT_GT(chi_square_uniform(leading).p_value, sidak(kComparisons));
  EXPECT_GT(chi_square_uniform(last).p_value, sidak(kComparisons));
}
using Bits = std::pair<std::uint32_t, std::uint32_t>;

TEST(SamplerTest, EveryDimensionIsUniform) {
  std::vector<std::vector<std::uint64_t>> counts(kDimensions, std::vector<std::uint64_t>(256, 0));
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    Sampler sampler(Sequence::kRandom, 1, i % 300, i / 300, 0);
    for (auto& dimension_counts : counts) ++dimension_counts[sampler.next_bits() >> 24];
  }
  for (const auto& dimension_counts : counts) {
    EXPECT_GT(chi_square_uniform(dimension_counts).p_value, sidak(kComparisons));
  }
}

TEST(SamplerTest, SamplesOfOnePixelAreUniform) {
  std::vector<std::vector<std::uint64_t>> counts(kDimensions, std::vector<std::uint64_t>(256, 0));
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    Sampler sampler(Sequence::kRandom, 1, 5, 3, i);
    for (auto& dimension_counts : counts) ++dimension_counts[sampler.next_bits() >> 24];
  }
  for (const auto& dimension_counts : counts) {
    EXPECT_GT(chi_square_uniform(dimension_counts).p_value, sidak(kComparisons));
  }
}

TEST(SamplerTest, DimensionsAreIndependent) {
  for (const std::uint32_t apart : {1U, 2U, 7U}) {
    expect_independent([&](std::uint32_t i) {
      const Sampler sampler(Sequence::kRandom, 2, i, 0, 0);
      return Bits(dimension(sampler, 0), dimension(sampler, apart));
    });
  }
}

TEST(SamplerTest, NeighboursAreIndependent) {
  expect_independent([](std::uint32_t i) {
    return Bits(dimension(random_sampler(3, i, 7, 0), 0), dimension(random_sampler(3, i + 1, 7, 0), 0));
  });
  expect_independent([](std::uint32_t i) {
    return Bits(dimension(random_sampler(3, 7, i, 0), 0), dimension(random_sampler(3, 7, i + 1, 0), 0));
  });
  expect_independent([](std::uint32_t i) {  // mirrored pixels
    return Bits(dimension(random_sampler(3, i, i + 1, 0), 0), dimension(random_sampler(3, i + 1, i, 0), 0));
  });
  expect_independent([](std::uint32_t i) {
    return Bits(dimension(random_sampler(3, 7, 7, i), 0), dimension(random_sampler(3, 7, 7, i + 1), 0));
  });
  expect_independent([](std::uint32_t i) {  // the next sample's first number is not this one's second
    return Bits(dimension(random_sampler(3, 7, 7, i), 1), dimension(random_sampler(3, 7, 7, i + 1), 0));
  });
  expect_independent([](std::uint32_t i) {
    return Bits(dimension(random_sampler(i, 7, 7, 0), 0), dimension(random_sampler(i + 1, 7, 7, 0), 0));
  });
}

TEST(SamplerTest, ChangingOneBitOfTheNameChangesHalfOfTheNumber) {
  std::uint64_t changed = 0;
  std::uint64_t pairs = 0;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const std::uint32_t base = dimension(random_sampler(i, i, i, i), 0);
    for (std::uint32_t bit = 0; bit < 32; ++bit) {
      const std::uint32_t flipped = i ^ (1U << bit);
      for (const Sampler& other :
           {random_sampler(flipped, i, i, i), random_sampler(i ^ (std::uint64_t{1} << (bit + 32)), i, i, i),
            random_sampler(i, flipped, i, i), random_sampler(i, i, flipped, i),
            random_sampler(i, i, i, flipped)}) {
        changed += static_cast<std::uint64_t>(std::popcount(base ^ dimension(other, 0)));
        ++pairs;
      }
    }
  }
  EXPECT_NEAR(static_cast<double>(changed) / static_cast<double>(pairs), 16.0, 0.05);
}

TEST(SamplerTest, StreamsDoNotRepeatOneAnother) {
  std::set<std::uint64_t> seen;  // of two numbers in sequence
  for (std::uint32_t i = 0; i < 10000; ++i) {
    Sampler sampler(Sequence::kRandom, 4, i % 100, i / 100, 0);
    std::uint64_t pair = sampler.next_bits();
    for (int n = 1; n < 8; ++n) {
      pair = pair << 32 | sampler.next_bits();
      EXPECT_TRUE(seen.insert(pair).second);
    }
  }
}

TEST(SamplerTest, AnySampleCanBeMadeAgain) {
  const auto first = [](std::uint64_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t sample) {
    Sampler sampler(Sequence::kRandom, seed, x, y, sample);
    return std::array{sampler.next_bits(), sampler.next_bits(), sampler.next_bits()};
  };
  EXPECT_EQ(first(1, 2, 3, 4), first(1, 2, 3, 4));
  EXPECT_NE(first(1, 2, 3, 4), first(2, 2, 3, 4));
  EXPECT_NE(first(1, 2, 3, 4), first(1, 3, 3, 4));
  EXPECT_NE(first(1, 2, 3, 4), first(1, 2, 4, 4));
  EXPECT_NE(first(1, 2, 3, 4), first(1, 2, 3, 5));
  EXPECT_NE(first(1, 2, 3, 4), first(1, 3, 2, 4));
}

template <class N>
class SamplerNumbersTest : public testing::Test {};
TYPED_TEST_SUITE(SamplerNumbersTest, NumberSystems, NumberSystemNames);

TYPED_TEST(SamplerNumbersTest, AreTheBitsAsFractions) {
  Sampler numbers(Sequence::kRandom, 5, 6, 7, 8);
  Sampler bits(Sequence::kRandom, 5, 6, 7, 8);
  for (int i = 0; i < 1000; ++i) {
    const auto x = numbers.next<TypeParam>();
    EXPECT_TRUE(x >= 0 && x < 1);
    EXPECT_NEAR(to_host(x), bits.next_bits() * 0x1p-32, 0x1p-24);
  }
}

}  // namespace
}  // namespace vitrine
