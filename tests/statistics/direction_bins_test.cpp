#include "statistics/direction_bins.h"

#include <gtest/gtest.h>

#include "numeric/float_numbers.h"
#include "sampling/warps.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

using N = FloatNumbers;
constexpr std::uint32_t kSamples = 200000;

double cosine_density(const glm::dvec3& w) { return std::max(0.0, w.z) / std::numbers::pi; }

// The cosine hemisphere, but for an exponent: 0.5 is right.
auto cosine_hemisphere(double exponent) {
  return [exponent](Sampler& sampler) -> std::optional<glm::dvec3> {
    const double phi = 2.0 * std::numbers::pi * static_cast<double>(sampler.next<N>());
    const double r = std::pow(static_cast<double>(sampler.next<N>()), exponent);
    return glm::dvec3(r * std::cos(phi), r * std::sin(phi), std::sqrt(1.0 - r * r));
  };
}

TEST(DirectionBinsTest, CoverTheSphereOnce) {
  for (const double half_angle : {0.002, 0.3, std::numbers::pi / 2}) {
    const DirectionBins bins(glm::dvec3(1, -2, 0.5), half_angle);
    double sphere = 0.0;
    for (const double cell : bins.integrate([](const glm::dvec3&) { return 1.0; })) sphere += cell;
    EXPECT_NEAR(sphere, 4.0 * std::numbers::pi, 1e-3);
  }
}

// A cell's solid angle is where cell() puts directions.
TEST(DirectionBinsTest, IntegrateWhatTheyCount) {
  for (const double half_angle : {0.5, std::numbers::pi / 2}) {
    const DirectionBins bins(glm::dvec3(-1, 2, 3), half_angle);
    const auto uniform = [](const glm::dvec3&) { return 0.25 / std::numbers::pi; };
    RandomInputs random(2);
    const auto result = compare_directions(
        bins, kSamples, [&](Sampler&) { return std::optional(random.direction()); }, uniform);
    EXPECT_GT(result.chi_square.p_value, sidak(2));
    EXPECT_GT(result.chi_square.degrees, 300);
  }
}

TEST(DirectionBinsTest, FindDiscontinuitiesAndPeaks) {
  const DirectionBins askew(glm::dvec3(1, 1, 1), 1.0);
  double half = 0.0;
  for (const double cell : askew.integrate([](const glm::dvec3& w) { return w.z > 0.0 ? 1.0 : 0.0; }))
    half += cell;
  EXPECT_NEAR(half, 2.0 * std::numbers::pi, 2e-3);
}

TEST(DirectionBinsTest, AcceptTheRightWarp) {
  const auto result = compare_directions(DirectionBins(), kSamples, cosine_hemisphere(0.5), cosine_density);
  EXPECT_NEAR(result.integral, 1.0, 1e-6);
  EXPECT_GT(result.chi_square.p_value, 0.001);
}

TEST(DirectionBinsTest, CatchAWrongWarp) {
  for (const double exponent : {0.48, 0.52}) {
    const auto result =
        compare_directions(DirectionBins(), kSamples, cosine_hemisphere(exponent), cosine_density);
    EXPECT_LT(result.chi_square.p_value, 1e-6) << exponent;
  }
  const auto uniform = compare_directions(
      DirectionBins(), kSamples,
      [](Sampler& s) {
        const float u = s.next<N>();
        const float v = s.next<N>();
        const Vec3<float> w = sample_uniform_hemisphere<N>(u, v);
        return std::optional(glm::dvec3(w));
      },
      cosine_density);
  EXPECT_LT(uniform.chi_square.p_value, 1e-12);
}

TEST(DirectionBinsTest, CatchADensityOfTheWrongSum) {
  const auto result = compare_directions(DirectionBins(), kSamples, cosine_hemisphere(0.5),
                                         [](const glm::dvec3& w) { return 0.99 * cosine_density(w); });
  EXPECT_NEAR(result.integral, 0.99, 1e-6);
  EXPECT_LT(result.chi_square.p_value, 1e-12);
}

}  // namespace
}  // namespace vitrine
