// Samples of the mixtures of lobes follow the density that eval() tells, and weigh what they should, in each
// of the four samplings.
#include <gtest/gtest.h>

#include "materials/bsdf.h"
#include "materials/test_surfaces.h"
#include "number_systems.h"
#include "statistics/direction_bins.h"
#include "statistics/z_test.h"

namespace vitrine {
namespace {

constexpr std::uint32_t kSamples = 40000;
constexpr std::array kCosines{0.9, 0.3};
constexpr int kComparisons = 2 * 4 * 2 * 18;

template <class N>
std::optional<BsdfSample<N>> draw(const Bsdf<N>& bsdf, Sampler& sampler) {
  const auto choice = sampler.next<N>();
  const auto u = sampler.next<N>();
  const auto v = sampler.next<N>();
  return bsdf.sample(choice, u, v);
}

std::string described(DirectionSampling how, const TestSurface& surface, double cosine) {
  return std::to_string(static_cast<int>(how)) + ' ' + surface.name + (surface.smooth ? " smooth " : " ") +
         std::to_string(cosine);
}

// The rough ones, and rough lobes beside delta lobes, which only they are counted of.
std::vector<TestSurface> sampled_surfaces() {
  std::vector<TestSurface> surfaces = rough_surfaces();
  for (const std::size_t i : {std::size_t{1}, std::size_t{3}, std::size_t{9}}) {
    surfaces.push_back(surfaces[i]);
    surfaces.back().smooth = true;
  }
  surfaces.push_back(surfaces[12]);
  surfaces.back().coat_smooth = true;
  return surfaces;
}

template <class N>
class BsdfSamplingTest : public testing::Test {};
TYPED_TEST_SUITE(BsdfSamplingTest, NumberSystems, NumberSystemNames);

TYPED_TEST(BsdfSamplingTest, DirectionsFollowTheDensity) {
  using Unit = typename TypeParam::Unit;
  for (const DirectionSampling how : kAllSamplings) {
    for (const TestSurface& surface : sampled_surfaces()) {
      for (const double cosine : kCosines) {
        const bool lobes_count = how == DirectionSampling::kBrdf || how == DirectionSampling::kBrdfCosine;
        if (!lobes_count && cosine == kCosines.back()) continue;
        const Bsdf<TypeParam> bsdf(baked<TypeParam>(surface), from_host<Unit>(at_cosine(cosine)), how);
        const DirectionComparison result = compare_directions(
            DirectionBins(), kSamples,
            [&](Sampler& sampler) -> std::optional<glm::dvec3> {
              const auto sample = draw(bsdf, sampler);
              if (!sample || sample->delta) return std::nullopt;
              return to_host(sample->wi);
            },
            [&](const glm::dvec3& w) { return to_host(bsdf.eval(from_host<Unit>(w)).pdf_w); });
        const std::string where = described(how, surface, cosine);
        EXPECT_LT(result.integral, 1.001) << where;
        EXPECT_GT(result.chi_square.p_value, sidak(kComparisons)) << where;
        EXPECT_GT(result.chi_square.degrees, 50) << where;
        if (lobes_count) continue;  // some of their samples go to the wrong side
        EXPECT_NEAR(result.integral, 1.0 - to_host(bsdf.prob_delta()), 1e-3) << where;
      }
    }
  }
}

TYPED_TEST(BsdfSamplingTest, SamplesTellWhatEvalTells) {
  using Unit = typename TypeParam::Unit;
  for (const DirectionSampling how : kAllSamplings) {
    for (const TestSurface& surface : sampled_surfaces()) {
      const Bsdf<TypeParam> bsdf(baked<TypeParam>(surface), from_host<Unit>(at_cosine(0.6)), how);
      for (std::uint32_t i = 0; i < 1000; ++i) {
        Sampler sampler(Sequence::kRandom, 5, i, 0, 0);
        const auto sample = draw(bsdf, sampler);
        if (!sample || sample->delta) continue;
        const BsdfValue<TypeParam> value = bsdf.eval(sample->wi);
        ASSERT_EQ(sample->pdf_w, value.pdf_w);
        const glm::dvec3 weight = to_host(value.f_cos) / to_host(value.pdf_w);
        ASSERT_LE(glm::length(to_host(sample->weight) - weight), 1e-6 * glm::length(weight)) << surface.name;
        ASSERT_NEAR(glm::length(to_host(sample->wi)), 1.0, 2e-6);
      }
    }
  }
}

// The mean weight is the albedo, of rough lobes by quadrature, whichever way the directions are found.
TYPED_TEST(BsdfSamplingTest, MeanWeightIsTheIntegral) {
  using Unit = typename TypeParam::Unit;
  for (const TestSurface& surface : rough_surfaces()) {
    for (const double cosine : kCosines) {
      const auto wo = from_host<Unit>(at_cosine(cosine));
      const Bsdf<TypeParam> any(baked<TypeParam>(surface), wo);
      double albedo = 0.0;
      for (const double cell : DirectionBins().integrate(
               [&](const glm::dvec3& w) { return to_host(any.eval(from_host<Unit>(w)).f_cos.y); })) {
        albedo += cell;
      }
      for (const DirectionSampling how : kAllSamplings) {
        const Bsdf<TypeParam> bsdf(baked<TypeParam>(surface), wo, how);
        double sum = 0.0;
        double squares = 0.0;
        for (std::uint32_t i = 0; i < kSamples; ++i) {
          Sampler sampler(Sequence::kRandom, 6, i, 0, 0);
          const auto sample = draw(bsdf, sampler);
          const double weight = sample ? to_host(sample->weight.y) : 0.0;
          sum += weight;
          squares += weight * weight;
        }
        const double mean = sum / kSamples;
        const double error = std::sqrt((squares / kSamples - mean * mean) / kSamples);
        EXPECT_NEAR(mean, albedo, sidak_limit(kComparisons) * error + 1e-4)
            << described(how, surface, cosine);
      }
    }
  }
}

// What the lecture says of the four: the more of the integrand a density follows, the less the weights vary.
TYPED_TEST(BsdfSamplingTest, TheMoreIsFollowedTheLessTheWeightsVary) {
  using Unit = typename TypeParam::Unit;
  const auto variance = [](const TestSurface& surface, DirectionSampling how) {
    const Bsdf<TypeParam> bsdf(baked<TypeParam>(surface), from_host<Unit>(at_cosine(0.6)), how);
    double sum = 0.0;
    double squares = 0.0;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      Sampler sampler(Sequence::kRandom, 8, i, 0, 0);
      const auto sample = draw(bsdf, sampler);
      const double weight = sample ? to_host(sample->weight.y) : 0.0;
      sum += weight / kSamples;
      squares += weight * weight / kSamples;
    }
    return squares - sum * sum;
  };
  const TestSurface lambert{.name = "lambert", .diffuse = glm::dvec3(0.5)};
  EXPECT_LT(variance(lambert, DirectionSampling::kCosine), 1e-9);
  EXPECT_LT(variance(lambert, DirectionSampling::kBrdfCosine), 1e-9);
  EXPECT_NEAR(variance(lambert, DirectionSampling::kUniform), 0.25 / 3.0, 0.005);  // of 2 cos / pi * pi / 2
  EXPECT_NEAR(variance(lambert, DirectionSampling::kBrdf), 0.25 / 3.0, 0.005);
  const TestSurface gold{.name = "gold", .f0 = glm::dvec3(1.0), .f90 = 1.0, .alpha = 0.1};
  EXPECT_LT(10.0 * variance(gold, DirectionSampling::kBrdf), variance(gold, DirectionSampling::kCosine));
  EXPECT_LT(variance(gold, DirectionSampling::kBrdfCosine), variance(gold, DirectionSampling::kBrdf));
}

}  // namespace
}  // namespace vitrine
