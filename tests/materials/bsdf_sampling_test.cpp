// Samples of the mixtures of lobes follow the density that eval() tells, and weigh what they should.
#include <gtest/gtest.h>

#include "materials/bsdf.h"
#include "materials/test_surfaces.h"
#include "number_systems.h"
#include "statistics/direction_bins.h"

namespace vitrine {
namespace {

constexpr std::uint32_t kSamples = 150000;
constexpr std::array kCosines{0.9, 0.3};
constexpr int kComparisons = 2 * 2 * 13;

template <class N>
std::optional<BsdfSample<N>> draw(const Bsdf<N>& bsdf, Sampler& sampler) {
  const auto choice = sampler.next<N>();
  const auto u = sampler.next<N>();
  const auto v = sampler.next<N>();
  return bsdf.sample(choice, u, v);
}

// The rough ones, and Lambert lobes beside delta lobes, which only they are counted of.
std::vector<TestSurface> sampled_surfaces() {
  std::vector<TestSurface> surfaces = rough_surfaces();
  for (const std::size_t i : {std::size_t{1}, std::size_t{3}, std::size_t{9}}) {
    surfaces.push_back(surfaces[i]);
    surfaces.back().smooth = true;
  }
  return surfaces;
}

template <class N>
class BsdfSamplingTest : public testing::Test {};
TYPED_TEST_SUITE(BsdfSamplingTest, NumberSystems, NumberSystemNames);

TYPED_TEST(BsdfSamplingTest, DirectionsFollowTheDensity) {
  using Unit = typename TypeParam::Unit;
  for (const TestSurface& surface : sampled_surfaces()) {
    for (const double cosine : kCosines) {
      const Bsdf<TypeParam> bsdf(baked<TypeParam>(surface), from_host<Unit>(at_cosine(cosine)));
      const DirectionComparison result = compare_directions(
          DirectionBins(), kSamples,
          [&](Sampler& sampler) -> std::optional<glm::dvec3> {
            const auto sample = draw(bsdf, sampler);
            if (!sample || sample->delta) return std::nullopt;
            return to_host(sample->wi);
          },
          [&](const glm::dvec3& w) { return to_host(bsdf.eval(from_host<Unit>(w)).pdf_w); });
      EXPECT_LT(result.integral, 1.001) << surface.name << ' ' << cosine;
      EXPECT_GT(result.chi_square.p_value, sidak(kComparisons))
          << surface.name << (surface.smooth ? " smooth " : " ") << cosine;
      EXPECT_GT(result.chi_square.degrees, 50) << surface.name << ' ' << cosine;
    }
  }
}

TYPED_TEST(BsdfSamplingTest, SamplesTellWhatEvalTells) {
  using Unit = typename TypeParam::Unit;
  for (const TestSurface& surface : sampled_surfaces()) {
    const Bsdf<TypeParam> bsdf(baked<TypeParam>(surface), from_host<Unit>(at_cosine(0.6)));
    for (std::uint32_t i = 0; i < 1000; ++i) {
      Sampler sampler(5, i, 0, 0);
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

// The mean weight is the albedo, of rough lobes by quadrature.
TYPED_TEST(BsdfSamplingTest, MeanWeightIsTheIntegral) {
  using Unit = typename TypeParam::Unit;
  for (const TestSurface& surface : rough_surfaces()) {
    for (const double cosine : kCosines) {
      const Bsdf<TypeParam> bsdf(baked<TypeParam>(surface), from_host<Unit>(at_cosine(cosine)));
      double albedo = 0.0;
      for (const double cell : DirectionBins().integrate(
               [&](const glm::dvec3& w) { return to_host(bsdf.eval(from_host<Unit>(w)).f_cos.y); })) {
        albedo += cell;
      }
      double sum = 0.0;
      double squares = 0.0;
      for (std::uint32_t i = 0; i < kSamples; ++i) {
        Sampler sampler(6, i, 0, 0);
        const auto sample = draw(bsdf, sampler);
        const double weight = sample ? to_host(sample->weight.y) : 0.0;
        sum += weight;
        squares += weight * weight;
      }
      const double mean = sum / kSamples;
      const double error = std::sqrt((squares / kSamples - mean * mean) / kSamples);
      EXPECT_NEAR(mean, albedo, 4.0 * error + 1e-4) << surface.name << ' ' << cosine;
    }
  }
}

}  // namespace
}  // namespace vitrine
