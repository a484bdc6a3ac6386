#include "lights/environment_map.h"

#include <functional>

#include <gtest/gtest.h>

#include "number_systems.h"
#include "statistics/direction_bins.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

using Shine = std::function<glm::dvec3(const glm::dvec3&)>;

/// The lattice of an environment that shines like this.
std::vector<glm::dvec3> lattice(int cells, const Shine& shine) {
  std::vector<glm::dvec3> radiance;
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      radiance.push_back(shine(octahedral_direction(2.0 * column / cells - 1.0, 2.0 * row / cells - 1.0)));
    }
  }
  return radiance;
}

/// The blend of the four points around `w`, in double.
glm::dvec3 blend(int cells, const std::vector<glm::dvec3>& radiance, const glm::dvec3& w) {
  const OctahedralPoint<double> p = octahedral_point(w);
  const double x = 0.5 * (p.x + 1.0) * cells;
  const double y = 0.5 * (p.y + 1.0) * cells;
  glm::dvec3 sum(0.0);
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      const double weight =
          std::max(0.0, 1.0 - std::abs(x - column)) * std::max(0.0, 1.0 - std::abs(y - row));
      if (weight > 0.0) sum += weight * radiance[static_cast<std::size_t>(row * (cells + 1) + column)];
    }
  }
  return sum;
}

const glm::dvec3 kSun = glm::normalize(glm::dvec3(0.5, 0.3, -0.8));

/// A sun of 1000 in a sky of 1, over black ground.
glm::dvec3 sunny(const glm::dvec3& w) {
  if (w.y < -0.2) return glm::dvec3(0.0);
  const double sun = 1000.0 * std::exp(-200.0 * (1.0 - glm::dot(w, kSun)));
  return glm::dvec3(0.3, 0.6, 1.0) + sun * glm::dvec3(1.0, 0.8, 0.5);
}
/// Blue light from a few directions below, nothing else.
glm::dvec3 sparse(const glm::dvec3& w) {
  return w.y < -0.6 && w.x > 0.0 ? glm::dvec3(0.0, 0.0, -w.y) : glm::dvec3(0.0);
}
glm::dvec3 white(const glm::dvec3& /*w*/) { return glm::dvec3(1.0); }

struct Sight {
  Shine shine;
  int cells;
  DirectionBins bins;
};
std::vector<Sight> sights() {
  return {{sunny, 16, DirectionBins(kSun, 0.4)},
          {sparse, 8, DirectionBins({0.3, -1.0, 0.1}, 0.8)},
          {white, 2, DirectionBins()}};
}

template <class N>
class EnvironmentMapTest : public testing::Test {
 protected:
  static Vec3<typename N::Unit> direction(const glm::dvec3& w) { return from_host<typename N::Unit>(w); }
};
TYPED_TEST_SUITE(EnvironmentMapTest, NumberSystems, NumberSystemNames);

TYPED_TEST(EnvironmentMapTest, TheSquareHoldsEveryDirectionOnce) {
  using Unit = typename TypeParam::Unit;
  RandomInputs random(3);
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 w = random.direction();
    const auto point = octahedral_point(this->direction(w));
    EXPECT_LE(std::abs(to_host(point.x)), 1.0 + 1e-6);
    EXPECT_LE(std::abs(to_host(point.y)), 1.0 + 1e-6);
    EXPECT_NEAR(to_host(point.taxicab), std::abs(w.x) + std::abs(w.y) + std::abs(w.z), 1e-6);
    ASSERT_LE(glm::length(to_host(octahedral_direction<Unit>(point.x, point.y)) - w),
              bound<TypeParam>(5e-7, 3e-8));
  }
  // The middle and the corners are front and back, each other axis has its place.
  EXPECT_EQ(to_host(octahedral_direction<Unit>(0, 0)), glm::dvec3(0, 0, 1));
  EXPECT_LE(glm::length(to_host(octahedral_direction<Unit>(1, 0)) - glm::dvec3(1, 0, 0)), 1e-7);
  EXPECT_LE(glm::length(to_host(octahedral_direction<Unit>(0, -1)) - glm::dvec3(0, -1, 0)), 1e-7);
  EXPECT_LE(glm::length(to_host(octahedral_direction<Unit>(-1, 1)) - glm::dvec3(0, 0, -1)), 1e-7);
}

TYPED_TEST(EnvironmentMapTest, BlendsTheLattice) {
  RandomInputs random(1);
  for (const Sight& sight : sights()) {
    const auto points = lattice(sight.cells, sight.shine);
    const EnvironmentMap<TypeParam> map(sight.cells, points);
    for (int i = 0; i < 3000; ++i) {
      const glm::dvec3 w = random.direction();
      const glm::dvec3 exact = blend(sight.cells, points, w);
      const glm::dvec3 radiance = to_host(map.radiance(this->direction(w)));
      ASSERT_LE(glm::length(radiance - exact), bound<TypeParam>(3e-3, 3e-5)) << "of up to 1000";
      if (sight.cells == 2) {
        EXPECT_LE(glm::length(radiance - glm::dvec3(1.0)), bound<TypeParam>(3e-7, 1e-8));
      }
    }
    for (const glm::dvec3& axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
      for (const double sign : {-1.0, 1.0}) {
        EXPECT_LE(glm::length(to_host(map.radiance(this->direction(sign * axis))) - sight.shine(sign * axis)),
                  1e-4);
      }
    }
  }
}

TYPED_TEST(EnvironmentMapTest, DirectionsFollowTheDensity) {
  for (const Sight& sight : sights()) {
    const EnvironmentMap<TypeParam> map(sight.cells, lattice(sight.cells, sight.shine));
    const DirectionComparison result = compare_directions(
        sight.bins, 200000,
        [&](Sampler& sampler) {
          const std::uint32_t bits = sampler.next_bits();
          const auto u = sampler.next<TypeParam>();
          const auto v = sampler.next<TypeParam>();
          const auto sample = map.sample(bits, u, v);
          if (!sample) return std::optional<glm::dvec3>();
          EXPECT_EQ(sample->radiance, map.radiance(sample->wi));
          EXPECT_EQ(sample->pdf_w, map.pdf_w(sample->wi));
          EXPECT_FALSE(sample->end);
          EXPECT_FALSE(sample->delta);
          EXPECT_NEAR(glm::length(to_host(sample->wi)), 1.0, 1e-6);
          return std::optional(to_host(sample->wi));
        },
        [&](const glm::dvec3& w) { return to_host(map.pdf_w(this->direction(w))); });
    EXPECT_NEAR(result.integral, 1.0, 1e-4);
    EXPECT_GT(result.chi_square.p_value, sidak(6));
  }
}

TYPED_TEST(EnvironmentMapTest, SamplesNoLightWhereThereIsNoneAndAllElsewhere) {
  RandomInputs random(2);
  const EnvironmentMap<TypeParam> map(8, lattice(8, sparse));
  int lit = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto w = this->direction(random.direction());
    const bool shines = max_component(map.radiance(w)) > 0;
    lit += shines ? 1 : 0;
    ASSERT_TRUE(!shines || map.pdf_w(w) > 0);
  }
  EXPECT_GT(lit, 1000);
  EXPECT_LT(lit, 10000);
}

// The estimator of the flux that next event estimation stands on: without bias, and with little variance,
// as the sun is found as often as it shines.
TYPED_TEST(EnvironmentMapTest, RadianceOverDensityIsTheFlux) {
  constexpr int kCells = 32;
  const auto points = lattice(kCells, sunny);
  const EnvironmentMap<TypeParam> map(kCells, points);
  RandomInputs random(4);
  double exact = 0.0;
  constexpr int kSteps = 16 * kCells;  // midpoints of the square
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const int column = i % kSteps;
    const int row = i / kSteps;
    const auto w =
        octahedral_direction((column + 0.5) * 2.0 / kSteps - 1.0, (row + 0.5) * 2.0 / kSteps - 1.0);
    const double area = 4.0 / kSteps / kSteps;
    exact += luminance<double>(to_host(map.radiance(this->direction(w)))) * area *
             std::pow(octahedral_point(w).taxicab, 3.0);
  }
  constexpr int kSamples = 100000;
  double sum = 0.0;
  double squares = 0.0;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const auto sample = map.sample(static_cast<std::uint32_t>(random.bits()),
                                   TypeParam::unit_from_bits(static_cast<std::uint32_t>(random.bits())),
                                   TypeParam::unit_from_bits(static_cast<std::uint32_t>(random.bits())));
    if (!sample) continue;
    const double flux = luminance<double>(to_host(sample->radiance)) / to_host(sample->pdf_w);
    sum += flux;
    squares += flux * flux;
  }
  const double mean = sum / kSamples;
  const double deviation = std::sqrt(squares / kSamples - mean * mean);
  EXPECT_NEAR(mean, exact, 4.0 * deviation / std::sqrt(kSamples));
  EXPECT_LT(deviation, 0.06 * mean);
  EXPECT_NEAR(map.mean_luminance() * 4.0 * std::numbers::pi, exact, 0.01 * exact);
}

}  // namespace
}  // namespace vitrine
