#include "sampling/discrete_distribution.h"

#include <gtest/gtest.h>

#include "number_systems.h"
#include "sampling/sampler.h"
#include "statistics/chi_square.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

constexpr std::uint32_t kSamples = 400000;

std::vector<double> random_weights(std::uint64_t seed, std::size_t count, double low, double high) {
  RandomInputs random(seed);
  std::vector<double> weights;
  for (std::size_t i = 0; i < count; ++i) weights.push_back(random.log_uniform(low, high));
  return weights;
}

const std::vector<std::vector<double>>& weight_lists() {
  static const std::vector<std::vector<double>> lists = {
      {1.0},
      {3.0, 1.0},
      {0.0, 2.0, 0.0, 1.0, 0.0},
      {1e-12, 1.0, 1e12},
      {1e-300, 1e-300, 3e-300},
      {1e300, 2e300},
      std::vector<double>(100, 0.1),
      random_weights(1, 64, 0.5, 2.0),
      random_weights(2, 1000, 1e-6, 1.0),
  };
  return lists;
}
constexpr int kComparisons = 2 * 9;

template <class N>
class DiscreteDistributionTest : public testing::Test {};
TYPED_TEST_SUITE(DiscreteDistributionTest, NumberSystems, NumberSystemNames);

// A probability is a multiple of 2^-32, and so is each entry's part in it: it may be off by a few of them.
TYPED_TEST(DiscreteDistributionTest, ProbabilitiesAreTheWeights) {
  for (const std::vector<double>& weights : weight_lists()) {
    const DiscreteDistribution<TypeParam> distribution(weights);
    ASSERT_EQ(distribution.size(), weights.size());
    double largest = 0.0;
    for (const double w : weights) largest = std::max(largest, w);
    double total = 0.0;
    for (const double w : weights) total += w / largest;
    double sum = 0.0;
    for (std::uint32_t i = 0; i < weights.size(); ++i) {
      const double prob = to_host(distribution.prob(i));
      const double exact = weights[i] / largest / total;
      EXPECT_NEAR(prob, exact, 8 * 0x1p-32 + exact * bound<TypeParam>(0x1p-23, 0x1p-30))
          << i << " of " << weights.size();
      EXPECT_EQ(prob > 0.0, weights[i] > 0.0) << i << " of " << weights.size();
      sum += prob;
    }
    EXPECT_NEAR(sum, 1.0, bound<TypeParam>(0x1p-23, 0x1p-30)) << weights.size();
  }
}

TYPED_TEST(DiscreteDistributionTest, SamplesByItsProbabilities) {
  for (const std::vector<double>& weights : weight_lists()) {
    const DiscreteDistribution<TypeParam> distribution(weights);
    std::vector<double> expected;
    for (std::uint32_t i = 0; i < weights.size(); ++i)
      expected.push_back(to_host(distribution.prob(i)) * kSamples);
    std::vector<std::uint64_t> observed(weights.size(), 0);
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      Sampler sampler(Sequence::kRandom, 3, i, 0, 0);
      ++observed[distribution.sample(sampler.next_bits())];
    }
    EXPECT_GT(chi_square(expected, observed).p_value, sidak(kComparisons)) << weights.size();
  }
}

// The numbers about every border between two outcomes.
TYPED_TEST(DiscreteDistributionTest, WithoutWeightIsNeverSampled) {
  const DiscreteDistribution<TypeParam> distribution(std::vector<double>{0.0, 2.0, 0.0, 1.0, 0.0});
  for (std::uint64_t part = 0; part <= 15; ++part) {
    for (std::uint64_t off = 0; off < 2000; ++off) {
      const auto bits = static_cast<std::uint32_t>((part << 32) / 15 + off - 1000);
      const std::uint32_t outcome = distribution.sample(bits);
      EXPECT_TRUE(outcome == 1 || outcome == 3) << bits;
    }
  }
}

// Where a step of one in 32 bits matters: probabilities are the number of ways, counted one by one.
TYPED_TEST(DiscreteDistributionTest, ProbabilitiesCountTheWays) {
  std::vector<double> weights(3000, 1e-12);
  weights[7] = 1.0;
  const DiscreteDistribution<TypeParam> distribution(weights);
  for (const std::uint32_t rare : {0U, 8U, 2999U}) {
    const std::uint64_t first = (std::uint64_t{rare} << 32) / 3000;
    double ways = 0;
    for (std::uint64_t bits = first; bits <= first + 5; ++bits) {
      if (distribution.sample(static_cast<std::uint32_t>(bits)) == rare) ++ways;
    }
    EXPECT_GE(ways, 1.0);
    EXPECT_EQ(to_host(distribution.prob(rare)), ways * 0x1p-32);
  }
}

TYPED_TEST(DiscreteDistributionTest, OfOneIsCertain) {
  const DiscreteDistribution<TypeParam> distribution(std::vector<double>{0.3});
  EXPECT_EQ(to_host(distribution.prob(0)), 1.0);
  EXPECT_EQ(distribution.sample(0xffffffffU), 0U);
}

}  // namespace
}  // namespace vitrine
