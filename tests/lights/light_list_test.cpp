// All lights under one index, and one of them at random.
#include "lights/light_list.h"

#include <gtest/gtest.h>

#include "lights/uniform_light_selection.h"
#include "number_systems.h"
#include "sampling/sampler.h"
#include "statistics/chi_square.h"

namespace vitrine {
namespace {

constexpr std::uint32_t kSamples = 200000;
constexpr std::array<std::uint32_t, 5> kCounts{1, 2, 7, 64, 1000};

template <class N>
class LightListTest : public testing::Test {};
TYPED_TEST_SUITE(LightListTest, NumberSystems, NumberSystemNames);

TYPED_TEST(LightListTest, MeshesPointsDirectionalAndTheSkyLast) {
  using Length = typename TypeParam::Length;
  using Unit = typename TypeParam::Unit;
  using Radiance = typename TypeParam::Radiance;
  const auto grey = [](double x) { return from_host<Radiance>(glm::dvec3(x)); };
  LightList<TypeParam> lights;
  EXPECT_EQ(lights.size(), 0U);
  lights.meshes.push_back(MeshLight<TypeParam>({{.corner = from_host<Length>(glm::dvec3(-1, 1, -1)),
                                                 .edge_u = from_host<Length>(glm::dvec3(1, 0, 0)),
                                                 .edge_v = from_host<Length>(glm::dvec3(0, 0, 1)),
                                                 .normal = from_host<Unit>(glm::dvec3(0, -1, 0)),
                                                 .triangle = 42,
                                                 .area = 0.5}},
                                               false));
  lights.points.push_back({.position = from_host<Length>(glm::dvec3(0, 1, 0)), .intensity = grey(2.0)});
  lights.points.push_back({.position = from_host<Length>(glm::dvec3(0, 1, 0)), .intensity = grey(3.0)});
  lights.directional.push_back({from_host<Unit>(glm::dvec3(0, 1, 0)), grey(4.0)});
  EXPECT_EQ(lights.size(), 4U);
  lights.sky = Sky<TypeParam>{grey(5.0), grey(5.0), grey(5.0)};
  ASSERT_EQ(lights.size(), 5U);
  EXPECT_EQ(lights.sky_index(), 4U);
  const auto sample = [&](std::uint32_t i) {
    return lights.sample(i, LightPoints::kArea, Vec3<Length>(0), 0U, Unit(0.25), Unit(0.25));
  };
  EXPECT_EQ(sample(0)->triangle, 42U);
  for (std::uint32_t i = 1; i < 5; ++i) {
    EXPECT_NEAR(to_host(sample(i)->radiance.x), i + 1.0, 1e-6);
    EXPECT_EQ(sample(i)->delta, i < 4);
  }
}

TYPED_TEST(LightListTest, UniformSelectionIsUniform) {
  for (const std::uint32_t count : kCounts) {
    const UniformLightSelection<TypeParam> selection(count);
    std::vector<std::uint64_t> observed(count, 0);
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      Sampler sampler(Sequence::kRandom, 1, i, 0, 0);
      const std::uint32_t chosen = selection.sample(sampler.next_bits());
      ASSERT_LT(chosen, count);
      ++observed[chosen];
    }
    EXPECT_GT(chi_square_uniform(observed).p_value, sidak(2 * static_cast<int>(kCounts.size()))) << count;
    EXPECT_NEAR(to_host(selection.prob(0)) * count, 1.0, 1e-7);
    EXPECT_EQ(selection.sample(0U), 0U);
    EXPECT_EQ(selection.sample(0xffffffffU), count - 1);
  }
  EXPECT_EQ(to_host(UniformLightSelection<TypeParam>(0).prob(0)), 0.0);
}

}  // namespace
}  // namespace vitrine
