#include "lights/sky.h"

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/host_conversion.h"
#include "statistics/direction_bins.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

const glm::dvec3 kZenith(0.2, 0.4, 0.8);
const glm::dvec3 kHorizon(0.9, 0.8, 0.7);
const glm::dvec3 kGround(0.1, 0.05, 0.025);

template <class N>
class SkyTest : public testing::Test {
 protected:
  static Sky<N> sky() {
    return {from_host<typename N::Radiance>(kZenith), from_host<typename N::Radiance>(kHorizon),
            from_host<typename N::Radiance>(kGround)};
  }
};
TYPED_TEST_SUITE(SkyTest, NumberSystems, NumberSystemNames);

TYPED_TEST(SkyTest, BlendsByHeight) {
  RandomInputs random(1);
  for (int i = 0; i < 10000; ++i) {
    const glm::dvec3 w = random.direction();
    const glm::dvec3 exact = w.y < 0.0 ? kGround : kHorizon * (1.0 - w.y) + kZenith * w.y;
    const glm::dvec3 radiance = to_host(this->sky().radiance(from_host<typename TypeParam::Unit>(w)));
    ASSERT_LE(glm::length(radiance - exact), bound<TypeParam>(5e-7, 2e-8));
  }
  const auto towards = [&](double y) {
    return to_host(this->sky().radiance(from_host<typename TypeParam::Unit>(glm::dvec3(0.0, y, 0.0))));
  };
  EXPECT_LE(glm::length(towards(1.0) - kZenith), 1e-7);
  EXPECT_LE(glm::length(towards(1.0 + 1e-7) - kZenith), 1e-6) << "a direction a little too long";
  EXPECT_LE(glm::length(towards(0.0) - kHorizon), 1e-7);
  EXPECT_LE(glm::length(towards(-1.0) - kGround), 1e-7);
}

TYPED_TEST(SkyTest, DirectionsFollowTheDensity) {
  const auto sky = this->sky();
  const DirectionComparison result = compare_directions(
      DirectionBins(), 300000,
      [&](Sampler& sampler) {
        const std::uint32_t bits = sampler.next_bits();
        const auto u = sampler.next<TypeParam>();
        const auto v = sampler.next<TypeParam>();
        const auto sample = sky.sample(bits, u, v);
        if (!sample) return std::optional<glm::dvec3>();
        EXPECT_EQ(sample->radiance, sky.radiance(sample->wi));
        EXPECT_EQ(sample->pdf_w, sky.pdf_w(sample->wi));
        EXPECT_FALSE(sample->end);
        EXPECT_FALSE(sample->delta);
        return std::optional(to_host(sample->wi));
      },
      [&](const glm::dvec3& w) { return to_host(sky.pdf_w(from_host<typename TypeParam::Unit>(w))); });
  EXPECT_NEAR(result.integral, 1.0, 1e-6);
  EXPECT_GT(result.chi_square.p_value, sidak(2));
}

// Perfect importance sampling: luminance over density is the same everywhere.
TYPED_TEST(SkyTest, TheDensityIsProportionalToTheLuminance) {
  const auto sky = this->sky();
  RandomInputs random(5);
  for (int i = 0; i < 10000; ++i) {
    const auto w = from_host<typename TypeParam::Unit>(random.direction());
    const double shown = luminance<double>(to_host(sky.radiance(w)));
    ASSERT_NEAR(shown / to_host(sky.pdf_w(w)) / (4.0 * std::numbers::pi * sky.mean_luminance()), 1.0, 1e-5);
  }
}

// Skies with dark parts: what does not shine is not sampled, and a black sky does no harm.
TYPED_TEST(SkyTest, DarkPartsAreNotSampled) {
  using Radiance = typename TypeParam::Radiance;
  const auto grey = [](double x) { return from_host<Radiance>(glm::dvec3(x)); };
  const Sky<TypeParam> above(grey(1.0), grey(0.0), grey(0.0));
  const Sky<TypeParam> below(grey(0.0), grey(0.0), grey(1.0));
  const Sky<TypeParam> black(grey(0.0), grey(0.0), grey(0.0));
  for (std::uint32_t i = 0; i < 10000; ++i) {
    Sampler sampler(Sequence::kRandom, 1, i, 0, 0);
    const std::uint32_t bits = sampler.next_bits();
    const auto u = sampler.next<TypeParam>();
    const auto v = sampler.next<TypeParam>();
    const auto up = above.sample(bits, u, v);
    EXPECT_TRUE(!up || up->wi.y > 0);
    const auto down = below.sample(bits, u, v);
    EXPECT_TRUE(!down || !(down->wi.y > 0));
    const auto none = black.sample(bits, u, v);
    EXPECT_TRUE(!none || to_host(none->radiance) == glm::dvec3(0.0));
  }
}

}  // namespace
}  // namespace vitrine
