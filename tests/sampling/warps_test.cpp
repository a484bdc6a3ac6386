#include "sampling/warps.h"

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/host_conversion.h"
#include "statistics/direction_bins.h"

namespace vitrine {
namespace {

constexpr std::uint32_t kSamples = 400000;
constexpr int kComparisons = 2 * 4;

template <class N>
class WarpsTest : public testing::Test {
 protected:
  // Counts the directions that `warp` makes and holds them against `density`.
  template <class Warp, class Density>
  void compare(const Warp& warp, const Density& density) {
    double longest_error = 0.0;
    const auto draw = [&](Sampler& sampler) {
      const auto u = sampler.next<N>();
      const auto v = sampler.next<N>();
      const glm::dvec3 w = to_host(warp(u, v));
      longest_error = std::max(longest_error, std::abs(glm::length(w) - 1.0));
      return std::optional(w);
    };
    const DirectionComparison result = compare_directions(DirectionBins(), kSamples, draw, density);
    EXPECT_NEAR(result.integral, 1.0, 1e-6);
    EXPECT_GT(result.chi_square.p_value, sidak(kComparisons));
    EXPECT_GT(result.chi_square.degrees, 200);
    EXPECT_LE(longest_error, bound<N>(4e-7, 1e-8));
  }
};
TYPED_TEST_SUITE(WarpsTest, NumberSystems, NumberSystemNames);

TYPED_TEST(WarpsTest, UniformHemisphere) {
  this->compare(sample_uniform_hemisphere<TypeParam>, [](const glm::dvec3& w) {
    return w.z > 0.0 ? to_host(pdf_uniform_hemisphere<TypeParam>()) : 0.0;
  });
}

TYPED_TEST(WarpsTest, UniformSphere) {
  this->compare(sample_uniform_sphere<TypeParam>,
                [](const glm::dvec3&) { return to_host(pdf_uniform_sphere<TypeParam>()); });
}

TYPED_TEST(WarpsTest, CosineHemisphere) {
  this->compare(sample_cosine_hemisphere<TypeParam>, [](const glm::dvec3& w) {
    return w.z > 0.0 ? to_host(pdf_cosine_hemisphere<TypeParam>(from_host<typename TypeParam::Unit>(w.z)))
                     : 0.0;
  });
}

// Barycentrics in the squares of a grid: those that the line s + t = 1 crosses are half in the triangle.
TYPED_TEST(WarpsTest, Triangle) {
  constexpr std::size_t kCells = 16;
  std::vector<double> expected(kCells * kCells, 0.0);
  std::vector<std::uint64_t> observed(expected.size(), 0);
  for (std::size_t i = 0; i < kCells; ++i) {
    for (std::size_t j = 0; i + j < kCells; ++j) {
      expected[i * kCells + j] = (i + j + 1 < kCells ? 2.0 : 1.0) * kSamples / (kCells * kCells);
    }
  }
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    Sampler sampler(Sequence::kRandom, 9, i, 0, 0);
    const auto u = sampler.next<TypeParam>();
    const auto v = sampler.next<TypeParam>();
    const auto b = sample_triangle<TypeParam>(u, v);
    const double second = to_host(b.x);
    const double third = to_host(b.y);
    ASSERT_TRUE(second >= 0.0 && third >= 0.0 && second + third <= 1.0 + 1e-7);
    ++observed[static_cast<std::size_t>(second * kCells) * kCells + static_cast<std::size_t>(third * kCells)];
  }
  EXPECT_GT(chi_square(expected, observed).p_value, sidak(kComparisons));
}

TYPED_TEST(WarpsTest, TheCornersOfTheSquareAreSafe) {
  using Unit = typename TypeParam::Unit;
  const Unit last = TypeParam::unit_from_bits(0xffffffffU);
  for (const Unit u : {Unit(0), last}) {
    for (const Unit v : {Unit(0), last}) {
      for (const auto& w :
           {sample_uniform_hemisphere<TypeParam>(u, v), sample_uniform_sphere<TypeParam>(u, v),
            sample_cosine_hemisphere<TypeParam>(u, v)}) {
        EXPECT_NEAR(glm::length(to_host(w)), 1.0, 1e-6);
      }
      EXPECT_GT(sample_uniform_hemisphere<TypeParam>(u, v).z, Unit(0));
      EXPECT_GT(sample_cosine_hemisphere<TypeParam>(u, v).z, Unit(0));
    }
  }
}

}  // namespace
}  // namespace vitrine
