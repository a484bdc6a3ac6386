// Every way to choose a light, on random lights of all kinds: choices follow the probabilities that are told,
// to the last number, and no light that gives a receiver anything is ever left out.
#include "lights/light_selection.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "lights/lights_of_all_kinds.h"
#include "number_systems.h"
#include "statistics/chi_square.h"

namespace vitrine {
namespace {

constexpr double kPi = std::numbers::pi;

template <class N>
class LightSelectionTest : public testing::Test {
 protected:
  static Receiver<N> receiver(RandomInputs& random, bool both_sides) {
    const glm::dvec3 position = random.in_cube(0.8);
    const glm::dvec3 normal = random.direction();
    return {from_host<typename N::Length>(position), from_host<typename N::Unit>(normal), both_sides};
  }
  static double total_prob(const LightSelectors<N>& selectors, LightSelection how,
                           const Receiver<N>& receiver, std::uint32_t count) {
    double sum = 0.0;
    for (std::uint32_t i = 0; i < count; ++i) sum += to_host(selectors.prob(how, receiver, i));
    return sum;
  }
};
TYPED_TEST_SUITE(LightSelectionTest, NumberSystems, NumberSystemNames);

TYPED_TEST(LightSelectionTest, ChoicesFollowTheirProbabilities) {
  constexpr int kReceivers = 12;
  constexpr int kSamples = 40000;
  RandomInputs random(1);
  for (const LightSelection how : {LightSelection::kUniform, LightSelection::kPower, LightSelection::kTree}) {
    for (std::uint32_t k = 0; k < kReceivers; ++k) {
      const LightsOfAllKinds<TypeParam> lights(random, k == 0 ? 1U : 3U + 4U * k);
      const LightSelectors<TypeParam> selectors(lights.emissions);
      const std::uint32_t count = lights.list.size();
      const Receiver<TypeParam> receiver = this->receiver(random, k % 3 == 0);
      std::vector<double> expected;
      for (std::uint32_t i = 0; i < count; ++i) {
        expected.push_back(kSamples * to_host(selectors.prob(how, receiver, i)));
      }
      const double nothing = 1.0 - this->total_prob(selectors, how, receiver, count);
      ASSERT_GE(nothing, -1e-6);
      expected.push_back(kSamples * std::max(nothing, 1e-7));
      std::vector<std::uint64_t> observed(count + 1, 0);
      for (int i = 0; i < kSamples; ++i) {
        const auto chosen = selectors.select(how, receiver, static_cast<std::uint32_t>(random.bits() >> 32));
        ++observed[chosen ? chosen->light : count];
        const auto& prob = chosen ? chosen->prob : typename TypeParam::Density(0);
        ASSERT_TRUE(!chosen || prob == selectors.prob(how, receiver, chosen->light));
      }
      EXPECT_GT(chi_square(expected, observed).p_value, sidak(2 * 3 * kReceivers))
          << static_cast<int>(how) << k;
    }
  }
}

// Every number leads to a light, and each light's numbers lie together, as many as its probability says.
TYPED_TEST(LightSelectionTest, TreeSharesOutAllNumbers) {
  constexpr int kDigits = 15;
  constexpr std::uint32_t kLights = 300;
  RandomInputs random(2);
  const auto lights = LightsOfAllKinds<TypeParam>::points(random, kLights);
  const LightSelectors<TypeParam> selectors(lights.emissions);
  for (int k = 0; k < 10; ++k) {
    const Receiver<TypeParam> receiver = this->receiver(random, true);
    const double sum = this->total_prob(selectors, LightSelection::kTree, receiver, kLights);
    EXPECT_NEAR(sum, 1.0, bound<TypeParam>(1e-6, 1e-12));
    std::vector<int> count(kLights, 0);
    std::uint32_t last = kLights;
    for (std::uint32_t i = 0; i < 1U << kDigits; ++i) {
      const auto chosen = selectors.select(LightSelection::kTree, receiver, i << (32 - kDigits));
      ASSERT_TRUE(chosen);
      ASSERT_TRUE(chosen->light == last || count[chosen->light] == 0) << "its numbers are apart";
      last = chosen->light;
      ++count[last];
    }
    for (std::uint32_t i = 0; i < kLights; ++i) {
      const double prob = to_host(selectors.prob(LightSelection::kTree, receiver, i));
      ASSERT_NEAR(count[i], std::ldexp(prob, kDigits), 1.0);
    }
  }
}

TYPED_TEST(LightSelectionTest, NoLightThatCountsIsLeftOut) {
  using Unit = typename TypeParam::Unit;
  RandomInputs random(3);
  int dark = 0;
  int lit = 0;
  for (int k = 0; k < 300; ++k) {
    const LightsOfAllKinds<TypeParam> lights(random, 1 + random.index(40));
    const LightSelectors<TypeParam> selectors(lights.emissions);
    for (int r = 0; r < 20; ++r) {
      Receiver<TypeParam> receiver = this->receiver(random, random.index(8) == 0);
      const std::uint32_t light = random.index(lights.list.size());
      if (r % 2 == 0) receiver.position = lights.place_near(random, light);
      const double prob = to_host(selectors.prob(LightSelection::kTree, receiver, light));
      ASSERT_TRUE(std::isfinite(prob));
      bool counts = false;
      for (int i = 0; i < 50 && !counts; ++i) {
        const auto bits = static_cast<std::uint32_t>(random.bits());
        const auto u = TypeParam::unit_from_bits(static_cast<std::uint32_t>(random.bits()));
        const auto v = TypeParam::unit_from_bits(static_cast<std::uint32_t>(random.bits()));
        const auto sample = lights.list.sample(light, LightPoints::kArea, receiver.position, bits, u, v);
        counts = sample && (receiver.both_sides || dot(sample->wi, receiver.normal) > Unit(0));
      }
      ++(counts ? lit : dark);
      ASSERT_TRUE(!counts || prob > 0.0) << "round " << k << ", light " << light;
    }
  }
  EXPECT_GT(lit, 1500);
  EXPECT_GT(dark, 1000);
}

TYPED_TEST(LightSelectionTest, TreeLeavesOutWhatTurnsItsBack) {
  using Length = typename TypeParam::Length;
  using Unit = typename TypeParam::Unit;
  LightsOfAllKinds<TypeParam> lights;
  lights.add_quad({-0.1, 0.5, -0.1}, {0.2, 0, 0}, {0, 0, 0.2}, false);  // shines down
  lights.add_quad({-0.1, 0.5, -0.1}, {0, 0, 0.2}, {0.2, 0, 0}, false);  // shines up
  lights.add_point({0.0, -0.9, 0.0});
  lights.finish({});
  const LightSelectors<TypeParam> selectors(lights.emissions);
  const Vec3<Unit> up(Unit(0), Unit(1), Unit(0));
  const Receiver<TypeParam> floor{from_host<Length>(glm::dvec3(0.0)), up, false};
  EXPECT_EQ(to_host(selectors.prob(LightSelection::kTree, floor, 0)), 1.0);
  EXPECT_EQ(to_host(selectors.prob(LightSelection::kTree, floor, 1)), 0.0);
  EXPECT_EQ(to_host(selectors.prob(LightSelection::kTree, floor, 2)), 0.0) << "below the horizon";
  const Receiver<TypeParam> ceiling{from_host<Length>(glm::dvec3(0.0, 0.9, 0.0)), -up, false};
  EXPECT_EQ(to_host(selectors.prob(LightSelection::kTree, ceiling, 0)), 0.0);
  EXPECT_GT(to_host(selectors.prob(LightSelection::kTree, ceiling, 1)), 0.5);
}

// Two equal lamps: the tree goes by the inverse square of the distance, where that is all that differs.
TYPED_TEST(LightSelectionTest, TreeGoesByTheSquareOfTheDistance) {
  using Length = typename TypeParam::Length;
  LightsOfAllKinds<TypeParam> lights;
  lights.add_point({0.1, 0.0, 0.0});
  lights.add_point({-0.3, 0.0, 0.0});
  lights.finish({});
  const LightSelectors<TypeParam> selectors(lights.emissions);
  const Receiver<TypeParam> receiver{from_host<Length>(glm::dvec3(0.0)), {}, true};
  EXPECT_NEAR(to_host(selectors.prob(LightSelection::kTree, receiver, 0)), 0.9, 1e-6);
  EXPECT_NEAR(to_host(selectors.prob(LightSelection::kTree, receiver, 1)), 0.1, 1e-6);
}

TYPED_TEST(LightSelectionTest, PowerGoesByThePowerAndForgetsNone) {
  const std::vector<double> powers{1.0, 10.0, 0.0, 5.0};
  std::vector<LightEmission> emissions;
  for (const double power : powers) {
    emissions.push_back(point_emission(glm::dvec3(0.0), 1.0));
    emissions.back().power = power;
  }
  const LightSelectors<TypeParam> selectors(emissions);
  const double least = 4.0 / 4096.0;
  const double total = 16.0 + least;
  for (std::uint32_t i = 0; i < powers.size(); ++i) {
    EXPECT_NEAR(to_host(selectors.prob(LightSelection::kPower, {}, i)), std::max(least, powers[i]) / total,
                1e-7);
  }
  const std::vector<LightEmission> black(3);
  EXPECT_NEAR(to_host(LightSelectors<TypeParam>(black).prob(LightSelection::kPower, {}, 1)), 1.0 / 3.0, 1e-7);
}

TYPED_TEST(LightSelectionTest, FewOrNoLights) {
  RandomInputs random(4);
  const LightSelectors<TypeParam> none{std::span<const LightEmission>()};
  const LightsOfAllKinds<TypeParam> one(random, 1);
  const LightSelectors<TypeParam> single(one.emissions);
  for (const LightSelection how : {LightSelection::kUniform, LightSelection::kPower, LightSelection::kTree}) {
    EXPECT_FALSE(none.select(how, {}, 0));
    EXPECT_EQ(single.select(how, {}, 0xffffffffU)->light, 0U);
    EXPECT_NEAR(to_host(single.prob(how, {}, 0)), 1.0, 1e-9);
  }
  EXPECT_EQ(to_host(single.prob(LightSelection::kAll, {}, 0)), 1.0);
}

// Many lights, far apart by powers of two or all in one place: none is out of reach of the tree.
TYPED_TEST(LightSelectionTest, TreesThatAreHardToBuild) {
  std::vector<LightEmission> shrinking;
  for (int i = 0; i < 3000; ++i) {
    shrinking.push_back(point_emission({std::pow(0.97, i), std::pow(0.9, i), 0.0}, std::pow(0.99, i)));
  }
  const std::vector<LightEmission> heap(5000, point_emission(glm::dvec3(0.25), 1.0));
  std::vector<LightEmission> suns;
  for (int i = 0; i < 100; ++i) suns.push_back(directional_emission({0, 1, 0}, 1.0, 1.0));
  RandomInputs random(5);
  const Receiver<TypeParam> receiver = this->receiver(random, true);
  for (const auto& emissions : {shrinking, heap, suns}) {
    const LightSelectors<TypeParam> selectors(emissions);
    const auto count = static_cast<std::uint32_t>(emissions.size());
    EXPECT_NEAR(this->total_prob(selectors, LightSelection::kTree, receiver, count), 1.0, 1e-5);
    for (std::uint32_t i = 0; i < count; i += 7) {
      const double prob = to_host(selectors.prob(LightSelection::kTree, receiver, i));
      ASSERT_GT(prob, 0.0);
      if (count != shrinking.size()) {
        ASSERT_NEAR(prob * count, 1.0, 1e-3);
      }
    }
  }
}

TEST(LightEmissionTest, PowerInClosedForm) {
  const std::vector<LightFacet> quad{
      {.corners = {glm::dvec3(0, 0, 0), glm::dvec3(2, 0, 0), glm::dvec3(0, 3, 0)},
       .normal = {0, 0, 1},
       .area = 3.0,
       .luminance = 5.0}};
  EXPECT_DOUBLE_EQ(mesh_emission(quad, false).power, kPi * 15.0);
  EXPECT_DOUBLE_EQ(mesh_emission(quad, true).power, kPi * 30.0);
  EXPECT_DOUBLE_EQ(mesh_emission(quad, false).intensity, 15.0);
  EXPECT_DOUBLE_EQ(point_emission({}, 2.0).power, 8.0 * kPi);
  const double cos_inner = std::cos(0.2);
  const double cos_outer = std::cos(0.7);
  double spot = 0.0;
  constexpr int kSteps = 100000;
  for (int i = 0; i < kSteps; ++i) {
    const double z = cos_outer + (1.0 - cos_outer) * (i + 0.5) / kSteps;
    spot += 2.0 * kPi * std::pow(std::min(1.0, (z - cos_outer) / (cos_inner - cos_outer)), 2);
  }
  spot *= 3.0 * (1.0 - cos_outer) / kSteps;
  EXPECT_NEAR(spot_emission({}, 3.0, {0, 0, 1}, cos_inner, cos_outer).power, spot, 1e-6);
  EXPECT_DOUBLE_EQ(directional_emission({0, 1, 0}, 3.0, 2.0).power, kPi * 4.0 * 3.0);
  EXPECT_DOUBLE_EQ(environment_emission(3.0, 2.0).power, 4.0 * kPi * kPi * 4.0 * 3.0);
}

TEST(ConeTest, UnionHoldsBoth) {
  RandomInputs random(6);
  for (int i = 0; i < 20000; ++i) {
    const Cone a{random.direction(), std::cos(random.uniform(0.0, random.index(2) == 0 ? 3.0 : 0.3))};
    const Cone b{random.direction(), std::cos(random.uniform(0.0, random.index(2) == 0 ? 3.0 : 0.3))};
    const Cone both = united(a, b);
    ASSERT_NEAR(glm::length(both.axis), 1.0, 1e-9);
    for (const Cone& part : {a, b}) {
      const double half = std::acos(part.cos_half);
      const double away = std::acos(std::clamp(glm::dot(part.axis, both.axis), -1.0, 1.0));
      ASSERT_LE(std::min(kPi, away + half), std::acos(std::max(-1.0, both.cos_half)) + 1e-6);
    }
    const double between = std::acos(std::clamp(glm::dot(a.axis, b.axis), -1.0, 1.0));
    const double needed = (std::acos(a.cos_half) + std::acos(b.cos_half) + between) / 2.0;
    const double widest = std::max({needed, std::acos(a.cos_half), std::acos(b.cos_half)});
    ASSERT_LE(std::acos(both.cos_half), std::min(kPi, widest) + 1e-6) << "wider than it need be";
  }
}

}  // namespace
}  // namespace vitrine
