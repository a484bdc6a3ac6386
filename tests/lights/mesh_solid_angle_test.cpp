// Sampling a light by the solid angle that is seen of it: the solid angle itself, the directions, and what it
// gains over sampling by area.
#include "lights/mesh_solid_angle.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "integrators/irradiance.h"
#include "lights/mesh_light.h"
#include "number_systems.h"
#include "numeric/host_conversion.h"
#include "sampling/sampler.h"
#include "statistics/chi_square.h"
#include "statistics/random_inputs.h"
#include "statistics/z_test.h"

namespace vitrine {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLeastSolidAngle = 0x1p-12;  // below, lights are sampled by their area

using Corners = std::vector<glm::dvec3>;  // of a parallelogram, in order

const Corners kPanel{{-0.4, 0.5, -0.3}, {0.4, 0.5, -0.3}, {0.4, 0.5, 0.3}, {-0.4, 0.5, 0.3}};  // shines down

// By the interior angles (Girard).
double solid_angle(const std::array<glm::dvec3, 3>& corners) {
  double sum = -kPi;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 a = glm::normalize(corners[i]);
    const glm::dvec3 b = glm::cross(a, glm::cross(corners[(i + 1) % 3], a));
    const glm::dvec3 c = glm::cross(a, glm::cross(corners[(i + 2) % 3], a));
    sum += std::atan2(glm::length(glm::cross(b, c)), glm::dot(b, c));
  }
  return sum;
}
double solid_angle(const Corners& quad, const glm::dvec3& p) {
  return solid_angle({quad[0] - p, quad[1] - p, quad[2] - p}) +
         solid_angle({quad[0] - p, quad[2] - p, quad[3] - p});
}

template <class N>
MeshLight<N> panel(const Corners& quad, bool two_sided = false) {
  std::vector<EmissiveTriangle<N>> triangles;
  for (std::uint32_t i = 0; i < 2; ++i) {
    const glm::dvec3 u = quad[i + 1] - quad[0];
    const glm::dvec3 v = quad[i + 2] - quad[0];
    const glm::dvec3 across = glm::cross(u, v);
    triangles.push_back({from_host<typename N::Length>(quad[0]), from_host<typename N::Length>(u),
                         from_host<typename N::Length>(v),
                         from_host<typename N::Unit>(glm::normalize(across)), i, 0.5 * glm::length(across)});
  }
  return MeshLight<N>(std::move(triangles), two_sided);
}

template <class N>
std::optional<LightSample<N>> draw(const MeshLight<N>& light, LightPoints points, const glm::dvec3& p,
                                   Sampler& sampler) {
  const std::uint32_t bits = sampler.next_bits();
  const auto u = sampler.next<N>();
  const auto v = sampler.next<N>();
  return light.sample(points, from_host<typename N::Length>(p), bits, u, v);
}

template <class N>
class MeshSolidAngleTest : public testing::Test {};
TYPED_TEST_SUITE(MeshSolidAngleTest, NumberSystems, NumberSystemNames);

TYPED_TEST(MeshSolidAngleTest, SolidAngleOfATriangle) {
  using Unit = typename TypeParam::Unit;
  const auto seen = [](const std::array<glm::dvec3, 3>& t) {
    return SphericalTriangle<TypeParam>(from_host<Unit>(glm::normalize(t[0])),
                                        from_host<Unit>(glm::normalize(t[1])),
                                        from_host<Unit>(glm::normalize(t[2])));
  };
  EXPECT_NEAR(to_host(seen({glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}).solid_angle()),
              kPi / 2, 1e-6);
  RandomInputs random(1);
  int sound = 0;
  for (int i = 0; i < 50000; ++i) {
    const double size = random.log_uniform(0.02, 2.0);
    const glm::dvec3 center = random.direction();
    const std::array<glm::dvec3, 3> t{center + random.direction() * size, center + random.direction() * size,
                                      center + random.direction() * size};
    const double exact = solid_angle(t);
    const SphericalTriangle<TypeParam> triangle = seen(t);
    if (!triangle.is_sound() || exact < kLeastSolidAngle) continue;
    ++sound;
    // Two corners that are almost opposite make it ill-conditioned.
    double least = 1.0;
    for (std::size_t k = 0; k < 3; ++k) {
      least = std::min(least, 1.0 + glm::dot(glm::normalize(t[k]), glm::normalize(t[(k + 1) % 3])));
    }
    const double tolerance = bound<TypeParam>(2e-6 + 1e-5 * exact, 5e-8 + 5e-8 * exact) / least;
    ASSERT_NEAR(to_host(triangle.solid_angle()), exact, tolerance) << i;
  }
  EXPECT_GT(sound, 30000);
}

struct View {
  const char* name;
  glm::dvec3 p;
};
const std::vector<View> kViews{{"below", {0.05, -0.2, 0.02}},       {"touching", {0.1, 0.48, 0.05}},
                               {"aside", {1.2, 0.3, 0.2}},          {"grazing", {0.9, 0.47, -0.1}},
                               {"under its edge", {0.4, 0.4, 0.1}}, {"far", {-0.9, -0.9, 0.9}}};

// The panel cut into cells: as many samples reach each as its solid angle is large.
TYPED_TEST(MeshSolidAngleTest, DirectionsAreUniformOverTheWholeLight) {
  using Length = typename TypeParam::Length;
  constexpr int kCells = 12;  // a side
  constexpr std::uint32_t kSamples = 200000;
  const MeshLight<TypeParam> light = panel<TypeParam>(kPanel);
  const glm::dvec3 x = kPanel[1] - kPanel[0];
  const glm::dvec3 z = kPanel[3] - kPanel[0];
  for (const auto& [name, p] : kViews) {
    const double whole = solid_angle(kPanel, p);
    std::vector<double> expected;
    for (int i = 0; i < kCells * kCells; ++i) {
      const glm::dvec3 corner =
          kPanel[0] + x * (1.0 / kCells * (i % kCells)) + z * (1.0 / kCells * (i / kCells));
      const Corners cell{corner, corner + x / 12.0, corner + x / 12.0 + z / 12.0, corner + z / 12.0};
      expected.push_back(kSamples * solid_angle(cell, p) / whole);
    }
    std::vector<std::uint64_t> observed(expected.size(), 0);
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      Sampler sampler(Sequence::kRandom, 7, i, 0, 0);
      const auto sample = draw(light, LightPoints::kSolidAngle, p, sampler);
      ASSERT_TRUE(sample) << name;
      const double u = to_host(sample->barycentric.x);
      const double v = to_host(sample->barycentric.y);
      ASSERT_TRUE(u >= 0.0 && v >= 0.0 && u + v <= 1.0 + 1e-6) << name << ' ' << u << ' ' << v;
      const double across = sample->triangle == 0 ? u + v : u;
      const double down = sample->triangle == 0 ? v : u + v;
      const auto cell = [](double at) {
        return std::min<std::size_t>(kCells - 1, static_cast<std::size_t>(at * kCells));
      };
      ++observed[cell(down) * kCells + cell(across)];
      const glm::dvec3 way = kPanel[0] + x * across + z * down - p;
      ASSERT_LE(glm::length(to_host(sample->wi) - glm::normalize(way)), bound<TypeParam>(2e-5, 1e-6)) << name;
      ASSERT_NEAR(to_host(sample->pdf_w) * whole, 1.0, bound<TypeParam>(2e-4, 2e-6)) << name;
      const auto by_chance = light.pdf_w(LightPoints::kSolidAngle, sample->triangle, from_host<Length>(p),
                                         sample->wi, from_host<Length>(glm::length(way)));
      ASSERT_EQ(by_chance, sample->pdf_w) << name;
    }
    EXPECT_GT(chi_square(expected, observed).p_value, sidak(2 * static_cast<int>(kViews.size()))) << name;
  }
}

// The irradiance of the panel by both techniques, and their variances.
TYPED_TEST(MeshSolidAngleTest, IrradianceIsTheClosedFormWithLessVarianceCloseBy) {
  constexpr std::uint32_t kBatches = 400;
  constexpr std::uint32_t kBatch = 50;
  const MeshLight<TypeParam> light = panel<TypeParam>(kPanel);
  struct Spot {
    glm::dvec3 p;
    glm::dvec3 n;
    double gain;  // area's variance is at least that many times as large
  };
  const std::vector<Spot> spots{{{0.0, 0.45, 0.0}, {0, 1, 0}, 5.0},
                                {{0.1, 0.2, 0.1}, {0, 1, 0}, 2.0},
                                {{0.5, 0.4, 0.0}, glm::normalize(glm::dvec3(-1.0, 0.3, 0.0)), 1.5},
                                {{0.2, -0.9, 0.1}, {0, 1, 0}, 1.0}};
  for (const Spot& spot : spots) {
    const double exact = polygon_irradiance(kPanel, spot.p, spot.n);
    double variance_by_area = 0.0;
    for (const LightPoints points : {LightPoints::kArea, LightPoints::kSolidAngle}) {
      std::vector<double> batches(kBatches, 0.0);
      for (std::uint32_t i = 0; i < kBatches * kBatch; ++i) {
        Sampler sampler(Sequence::kRandom, 11, i, 0, 0);
        const auto sample = draw(light, points, spot.p, sampler);
        if (!sample) continue;
        const double cosine = std::max(0.0, glm::dot(to_host(sample->wi), spot.n));
        batches[i / kBatch] += cosine / to_host(sample->pdf_w) / kBatch;
      }
      const Estimate shown = estimate(batches);
      EXPECT_LT(std::abs(z_score(shown, exactly(exact), 1e-5 * exact)),
                sidak_limit(2 * 2 * spots.size(), 0.01));
      if (points == LightPoints::kArea) {
        variance_by_area = shown.variance;
      } else {
        EXPECT_GT(variance_by_area, spot.gain * shown.variance) << spot.p.y;
      }
    }
  }
}

// Where the arithmetic would not hold, points and densities are those of area sampling, for either side.
TYPED_TEST(MeshSolidAngleTest, FallsBackToArea) {
  using Length = typename TypeParam::Length;
  const Corners tiny{{0.0, 0.5, 0.0}, {0.01, 0.5, 0.0}, {0.01, 0.5, 0.01}, {0.0, 0.5, 0.01}};
  const std::vector<std::pair<Corners, glm::dvec3>> cases{
      {tiny, {0.3, -0.5, 0.0}}, {kPanel, {0.0, 0.49999, 0.0}}, {kPanel, {0.4, 0.49999, 0.0}}};
  for (const auto& [corners, p] : cases) {
    const MeshLight<TypeParam> light = panel<TypeParam>(corners);
    for (std::uint32_t i = 0; i < 1000; ++i) {
      Sampler sampler(Sequence::kRandom, 12, i, 0, 0);
      Sampler again = sampler;
      const auto by_angle = draw(light, LightPoints::kSolidAngle, p, sampler);
      const auto by_area = draw(light, LightPoints::kArea, p, again);
      ASSERT_EQ(by_angle.has_value(), by_area.has_value());
      if (!by_area) continue;
      ASSERT_EQ(by_angle->wi, by_area->wi);
      ASSERT_EQ(by_angle->pdf_w, by_area->pdf_w);
      const auto distance = from_host<Length>(0.1);
      const auto from = from_host<Length>(p);
      ASSERT_EQ(light.pdf_w(LightPoints::kSolidAngle, by_area->triangle, from, by_area->wi, distance),
                light.pdf_w(LightPoints::kArea, by_area->triangle, from, by_area->wi, distance));
    }
  }
}

TYPED_TEST(MeshSolidAngleTest, ABackThatIsTurnedIsNotSampled) {
  const glm::dvec3 above(0.1, 0.9, 0.1);
  Sampler sampler(Sequence::kRandom, 13, 0, 0, 0);
  EXPECT_FALSE(draw(panel<TypeParam>(kPanel), LightPoints::kSolidAngle, above, sampler));
  EXPECT_TRUE(draw(panel<TypeParam>(kPanel, true), LightPoints::kSolidAngle, above, sampler));
}

// A roof of two panels of which only one is seen, and any view of a thin or distant light: always a number.
TYPED_TEST(MeshSolidAngleTest, AnyViewGivesFiniteDensities) {
  RandomInputs random(2);
  int samples = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 corner = random.in_cube(0.8);
    const glm::dvec3 u = random.direction() * random.log_uniform(1e-4, 1.0);
    const glm::dvec3 v = random.direction() * random.log_uniform(1e-4, 1.0);
    const MeshLight<TypeParam> light =
        panel<TypeParam>({corner, corner + u, corner + u + v, corner + v}, i % 2 == 0);
    const glm::dvec3 p =
        i % 4 < 2 ? random.in_cube() : corner + (u + v) * random.uniform() + random.direction() * 1e-3;
    Sampler sampler(Sequence::kRandom, 14, static_cast<std::uint32_t>(i), 0, 0);
    const auto sample = draw(light, LightPoints::kSolidAngle, p, sampler);
    if (!sample) continue;
    ++samples;
    ASSERT_TRUE(std::isfinite(to_host(sample->pdf_w)));
    ASSERT_GT(to_host(sample->pdf_w), 0.0);
    ASSERT_NEAR(glm::length(to_host(sample->wi)), 1.0, 1e-5);
    ASSERT_GE(to_host(sample->barycentric.x), 0.0);
    ASSERT_GE(to_host(sample->barycentric.y), 0.0);
    ASSERT_LE(to_host(sample->barycentric.x) + to_host(sample->barycentric.y), 1.0 + 1e-6);
  }
  EXPECT_GT(samples, 10000);
}

}  // namespace
}  // namespace vitrine
