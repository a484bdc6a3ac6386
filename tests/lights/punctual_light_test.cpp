// Point, spot and directional lights against the closed forms of KHR_lights_punctual.
#include "lights/punctual_light.h"

#include <cmath>

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/host_conversion.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

template <class N>
class PunctualLightTest : public testing::Test {
 protected:
  static PointLight<N> point(const glm::dvec3& position, const glm::dvec3& intensity) {
    return {.position = from_host<typename N::Length>(position),
            .intensity = from_host<typename N::Radiance>(intensity)};
  }
  static PointLight<N> spot(double inner, double outer) {  // at the origin, shining down
    PointLight<N> light = point(glm::dvec3(0.0), glm::dvec3(1.0));
    light.spot = true;
    light.axis = from_host<typename N::Unit>(glm::dvec3(0, -1, 0));
    light.cos_outer = from_host<typename N::Unit>(std::cos(outer));
    light.cone_scale = from_host<typename N::Density>(1.0 / (std::cos(inner) - std::cos(outer)));
    return light;
  }
  // What the spot gives at unit distance at an angle from its axis; nothing is zero.
  static double at_angle(const PointLight<N>& light, double angle) {
    const auto sample =
        light.sample(from_host<typename N::Length>(glm::dvec3(std::sin(angle), -std::cos(angle), 0.0)));
    return sample ? to_host(sample->radiance.x) : 0.0;
  }
};
TYPED_TEST_SUITE(PunctualLightTest, NumberSystems, NumberSystemNames);

TYPED_TEST(PunctualLightTest, PointFallsWithTheSquareOfTheDistance) {
  RandomInputs random(1);
  const glm::dvec3 intensity(0.5, 3.0, 0.001);
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 position = random.in_cube();
    const glm::dvec3 p = position + random.direction() * random.log_uniform(0.002, 1.0);
    const auto sample = this->point(position, intensity).sample(from_host<typename TypeParam::Length>(p));
    ASSERT_TRUE(sample);
    const glm::dvec3 way = to_host(from_host<typename TypeParam::Length>(position)) -
                           to_host(from_host<typename TypeParam::Length>(p));
    const glm::dvec3 exact = intensity / glm::dot(way, way);
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(to_host(sample->radiance)[c], exact[c], exact[c] * bound<TypeParam>(1e-4, 5e-6));
    ASSERT_LE(glm::length(to_host(sample->wi) - glm::normalize(way)), bound<TypeParam>(1e-4, 5e-6));
    ASSERT_TRUE(sample->delta);
    ASSERT_EQ(to_host(sample->pdf_w), 1.0);
    ASSERT_TRUE(sample->end);
    ASSERT_EQ(*sample->end, from_host<typename TypeParam::Length>(position));
    ASSERT_EQ(sample->triangle, kNoTriangle);
  }
}

TYPED_TEST(PunctualLightTest, AtThePointItselfThereIsNoDirection) {
  const auto light = this->point(glm::dvec3(0.25), glm::dvec3(1.0));
  EXPECT_FALSE(light.sample(light.position));
}

TYPED_TEST(PunctualLightTest, SpotFallsOffBetweenItsCones) {
  constexpr double kInner = 0.3;
  constexpr double kOuter = 0.7;
  const auto light = this->spot(kInner, kOuter);
  for (double angle = 0.0; angle < 3.1; angle += 0.003) {
    const double ramp =
        std::clamp((std::cos(angle) - std::cos(kOuter)) / (std::cos(kInner) - std::cos(kOuter)), 0.0, 1.0);
    ASSERT_NEAR(this->at_angle(light, angle), ramp * ramp, bound<TypeParam>(5e-6, 1e-7)) << angle;
  }
  EXPECT_NEAR(this->at_angle(light, 0.0), 1.0, 1e-6);
  EXPECT_NEAR(this->at_angle(light, kInner), 1.0, 1e-5);
  EXPECT_LT(this->at_angle(light, kOuter), 1e-9);
  EXPECT_EQ(this->at_angle(light, kOuter + 1e-3), 0.0);
  EXPECT_EQ(this->at_angle(light, 3.14), 0.0) << "behind it";
}

TYPED_TEST(PunctualLightTest, SpotOfHalfASphereAndOfAHardEdge) {
  const auto half = this->spot(0.0, std::acos(0.0));
  EXPECT_NEAR(this->at_angle(half, 0.0), 1.0, 1e-6);
  EXPECT_NEAR(this->at_angle(half, 1.0), std::pow(std::cos(1.0), 2), 1e-6);
  const auto hard = this->spot(0.4999, 0.5);
  EXPECT_NEAR(this->at_angle(hard, 0.499), 1.0, 1e-6);
  EXPECT_EQ(this->at_angle(hard, 0.501), 0.0);
}

TYPED_TEST(PunctualLightTest, DirectionalIsTheSameEverywhere) {
  using Radiance = typename TypeParam::Radiance;
  const auto wi = from_host<typename TypeParam::Unit>(glm::normalize(glm::dvec3(1, 2, 3)));
  const Vec3<Radiance> lux(Radiance(1), Radiance(2), Radiance(3));
  const LightSample<TypeParam> sample = DirectionalLight<TypeParam>{wi, lux}.sample();
  EXPECT_EQ(sample.wi, wi);
  EXPECT_EQ(sample.radiance, lux);
  EXPECT_FALSE(sample.end) << "infinitely far";
  EXPECT_TRUE(sample.delta);
  EXPECT_EQ(to_host(sample.pdf_w), 1.0);
}

}  // namespace
}  // namespace vitrine
