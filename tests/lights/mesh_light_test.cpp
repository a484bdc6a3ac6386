#include "lights/mesh_light.h"

#include <gtest/gtest.h>

#include "number_systems.h"
#include "sampling/sampler.h"
#include "statistics/direction_bins.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

constexpr std::uint32_t kSamples = 300000;
constexpr int kComparisons = 2 * 2;

struct HostTriangle {
  glm::dvec3 a, b, c;

  [[nodiscard]] double area() const { return 0.5 * glm::length(glm::cross(b - a, c - a)); }
  [[nodiscard]] glm::dvec3 normal() const { return glm::normalize(glm::cross(b - a, c - a)); }
};

// A lamp of unequal triangles in different planes.
const std::vector<HostTriangle>& lamp() {
  static const std::vector<HostTriangle> triangles = {
      {{-0.5, 0.9, -0.5}, {0.5, 0.9, -0.5}, {0.5, 0.9, 0.5}},
      {{-0.5, 0.9, -0.5}, {0.5, 0.9, 0.5}, {-0.5, 0.9, 0.1}},
      {{0.5, 0.9, 0.5}, {0.5, 0.9, -0.5}, {0.7, 0.6, 0.0}},
      {{-0.5, 0.9, 0.1}, {-0.48, 0.9, 0.12}, {-0.5, 0.85, 0.15}},
  };
  return triangles;
}

double lamp_area() {
  double area = 0.0;
  for (const HostTriangle& t : lamp()) area += t.area();
  return area;
}

template <class N>
MeshLight<N> mesh_light(const std::vector<HostTriangle>& triangles, bool two_sided) {
  std::vector<EmissiveTriangle<N>> emissive;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const HostTriangle& t = triangles[i];
    emissive.push_back({.corner = from_host<typename N::Length>(t.a),
                        .edge_u = from_host<typename N::Length>(t.b - t.a),
                        .edge_v = from_host<typename N::Length>(t.c - t.a),
                        .normal = from_host<typename N::Unit>(t.normal()),
                        .triangle = 100 + i,
                        .area = t.area()});
  }
  return MeshLight<N>(std::move(emissive), two_sided);
}

template <class N>
std::optional<LightSample<N>> draw(const MeshLight<N>& light, const glm::dvec3& from, Sampler& sampler) {
  const std::uint32_t bits = sampler.next_bits();
  const auto u = sampler.next<N>();
  const auto v = sampler.next<N>();
  return light.sample(LightPoints::kArea, from_host<typename N::Length>(from), bits, u, v);
}

template <class N>
class MeshLightTest : public testing::Test {};
TYPED_TEST_SUITE(MeshLightTest, NumberSystems, NumberSystemNames);

// Points over the triangles, each cut into the cells of a grid of barycentrics (half cells along its slope).
TYPED_TEST(MeshLightTest, PointsAreUniformByArea) {
  constexpr std::size_t kCells = 8;
  const MeshLight<TypeParam> light = mesh_light<TypeParam>(lamp(), true);
  std::vector<double> expected;
  for (const HostTriangle& t : lamp()) {
    for (std::size_t cell = 0; cell < kCells * kCells; ++cell) {
      const std::size_t diagonal = cell / kCells + cell % kCells + 1;
      const double share = diagonal < kCells ? 2.0 : (diagonal == kCells ? 1.0 : 0.0);
      expected.push_back(t.area() / lamp_area() * share / (kCells * kCells) * kSamples);
    }
  }
  std::vector<std::uint64_t> observed(expected.size(), 0);
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    Sampler sampler(Sequence::kRandom, 1, i, 0, 0);
    const auto sample = draw(light, {0.01, -0.5, 0.02}, sampler);
    ASSERT_TRUE(sample);
    const auto row = static_cast<std::size_t>(to_host(sample->barycentric.x) * kCells);
    const auto column = static_cast<std::size_t>(to_host(sample->barycentric.y) * kCells);
    ++observed[(sample->triangle - 100) * kCells * kCells + row * kCells + column];
  }
  EXPECT_GT(chi_square(expected, observed).p_value, sidak(kComparisons));
}

TYPED_TEST(MeshLightTest, DensityIsThatOfAreaSeenFromThePoint) {
  const MeshLight<TypeParam> light = mesh_light<TypeParam>(lamp(), true);
  RandomInputs random(1);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    Sampler sampler(Sequence::kRandom, 2, i, 0, 0);
    const glm::dvec3 p = random.in_cube(0.9);
    const auto sample = draw(light, p, sampler);
    if (!sample) continue;
    const HostTriangle& t = lamp()[sample->triangle - 100];
    const glm::dvec3 point =
        t.a + (t.b - t.a) * to_host(sample->barycentric.x) + (t.c - t.a) * to_host(sample->barycentric.y);
    const glm::dvec3 way = point - p;
    const double cosine = std::abs(glm::dot(glm::normalize(way), t.normal()));
    if (cosine < 0.02 || glm::length(way) < 0.02) continue;
    const double exact = glm::dot(way, way) / (cosine * lamp_area());
    ASSERT_NEAR(to_host(sample->pdf_w), exact, exact * bound<TypeParam>(2e-5, 1e-6));
    ASSERT_LE(glm::length(to_host(sample->wi) - glm::normalize(way)), bound<TypeParam>(1e-5, 1e-6));
    // The shadow ray ends just off the light, on the side of the point.
    ASSERT_TRUE(sample->end);
    const glm::dvec3 end = to_host(*sample->end);
    const double off = to_host(ray_offset<TypeParam>());
    ASSERT_NEAR(glm::length(end - point), off, bound<TypeParam>(5e-7, 1e-7));
    ASSERT_LT(glm::length(end - p), glm::length(way));
    ASSERT_FALSE(sample->delta);
    // What a ray that happens to hit the light is told agrees.
    const auto distance = from_host<typename TypeParam::Length>(glm::length(way));
    ASSERT_NEAR(to_host(light.pdf_w(LightPoints::kArea, sample->triangle - 100,
                                    from_host<typename TypeParam::Length>(p), sample->wi, distance)),
                exact, exact * 4e-5);
  }
}

// Directions to a single triangle against its density per solid angle, with no light where it is not.
TYPED_TEST(MeshLightTest, DirectionsFollowTheDensity) {
  using Unit = typename TypeParam::Unit;
  const HostTriangle t{{-0.9, 0.5, -0.9}, {-0.9, 0.5, 0.9}, {0.9, 0.5, 0.9}};
  const MeshLight<TypeParam> light = mesh_light<TypeParam>({t}, true);
  const glm::dvec3 p(-0.2, 0.1, 0.1);
  const DirectionBins bins(glm::dvec3(0, 1, 0), 1.0);
  const DirectionComparison result = compare_directions(
      bins, kSamples,
      [&](Sampler& sampler) {
        const auto sample = draw(light, p, sampler);
        return sample ? std::optional(to_host(sample->wi)) : std::nullopt;
      },
      [&](const glm::dvec3& w) {
        const double distance = glm::dot(t.a - p, t.normal()) / glm::dot(w, t.normal());
        if (!(distance > 0.0) || distance > 6.0) return 0.0;
        const glm::dvec3 q = p + w * distance;
        for (const auto& [a, b] : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)}) {
          if (glm::dot(glm::cross(b - a, q - a), t.normal()) < 0.0) return 0.0;
        }
        return to_host(light.pdf_w(LightPoints::kArea, 0, from_host<typename TypeParam::Length>(p),
                                   from_host<Unit>(w), from_host<typename TypeParam::Length>(distance)));
      });
  EXPECT_NEAR(result.integral, 1.0, 1e-3);
  EXPECT_GT(result.chi_square.p_value, sidak(kComparisons));
}

TYPED_TEST(MeshLightTest, ShinesFromItsFrontOnlyUnlessTwoSided) {
  using Unit = typename TypeParam::Unit;
  const HostTriangle t{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};  // its front faces +z
  for (const bool two_sided : {false, true}) {
    const MeshLight<TypeParam> light = mesh_light<TypeParam>({t}, two_sided);
    Sampler sampler(Sequence::kRandom, 3, 0, 0, 0);
    EXPECT_TRUE(draw(light, {0.2, 0.2, 0.5}, sampler));
    EXPECT_EQ(static_cast<bool>(draw(light, {0.2, 0.2, -0.5}, sampler)), two_sided);
    const Vec3<Unit> down(Unit(0), Unit(0), Unit(-1));
    const typename TypeParam::Length half(0.5);
    const auto pdf_w = [&](const Vec3<Unit>& wi) {
      return to_host(light.pdf_w(LightPoints::kArea, 0, {}, wi, half));
    };
    EXPECT_NEAR(pdf_w(down), 0.25 / 0.5, 1e-6);
    EXPECT_NEAR(pdf_w(-down), two_sided ? 0.25 / 0.5 : 0.0, 1e-6);
    const Vec3<Unit> aside(Unit(1), Unit(0), Unit(0));
    EXPECT_EQ(pdf_w(aside), 0.0) << "edge-on";
    EXPECT_FALSE(draw(light, {3.0, 0.0, 0.0}, sampler)) << "edge-on";
  }
}

}  // namespace
}  // namespace vitrine
