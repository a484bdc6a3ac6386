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
        const auto u = sampler.next<TypeParam>();
        const auto v = sampler.next<TypeParam>();
        const LightSample<TypeParam> sample = sky.sample(u, v);
        EXPECT_EQ(sample.radiance, sky.radiance(sample.wi));
        EXPECT_EQ(sample.pdf_w, sky.pdf_w());
        EXPECT_FALSE(sample.end);
        EXPECT_FALSE(sample.delta);
        return std::optional(to_host(sample.wi));
      },
      [&](const glm::dvec3&) { return to_host(sky.pdf_w()); });
  EXPECT_NEAR(result.integral, 1.0, 1e-6);
  EXPECT_GT(result.chi_square.p_value, sidak(2));
}

}  // namespace
}  // namespace vitrine
