// What light selection is told of the lights of baked scenes, and what that is worth in a hall of 64 lamps.
#include "scene/light_emissions.h"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/color.h"
#include "numeric/host_conversion.h"
#include "scene/bake.h"
#include "scene/gltf_import.h"
#include "scene/made_scene.h"
#include "source_file.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

constexpr double kPi = std::numbers::pi;

template <class N>
class LightEmissionsTest : public testing::Test {
 protected:
  // Lumens, lux or candela of baked units: powers go with the square of lengths.
  static double lumens(const World<N>& world, double power) {
    return std::ldexp(power, world.exponent) / (world.scale * world.scale);
  }
};
TYPED_TEST_SUITE(LightEmissionsTest, NumberSystems, NumberSystemNames);

TYPED_TEST(LightEmissionsTest, PowersAreLumens) {
  Scene scene;
  place(scene, {{-2, 0, -2}, {0, 0, 4}, {4, 0, 0}}, matte(glm::vec3(0.5F)));
  place(scene, {{-0.5, 1, -0.5}, {1, 0, 0}, {0, 0, 2}}, lamp(glm::vec3(30.0F)));
  place(scene, {{-0.5, 1, -0.5}, {1, 0, 0}, {0, 0, 2}}, lamp(glm::vec3(30.0F), true));
  scene.lights.push_back(point_light(glm::vec3(7.0F), {0.0, 0.5, 0.0}));
  scene.lights.push_back(sun(glm::vec3(500.0F), {0.0, -1.0, 0.0}));
  scene.environment = Environment{glm::vec3(20.0F), glm::vec3(20.0F), glm::vec3(20.0F)};
  scene.cameras.push_back(look_at({0.0, 1.0, 3.0}, glm::dvec3(0.0)));
  const auto world = bake_world<TypeParam>(scene);
  const std::vector<LightEmission> lights = light_emissions(world);
  ASSERT_EQ(lights.size(), 5U);
  const auto near = [](double exact) { return exact * 1e-5; };
  const double radius_squared = (4.0 * 4.0 + 4.0 * 4.0 + 1.0) / 4.0;
  const std::vector<double> exact{kPi * 2.0 * 30.0, 2.0 * kPi * 2.0 * 30.0, 4.0 * kPi * 7.0,
                                  kPi * radius_squared * 500.0, 4.0 * kPi * kPi * radius_squared * 20.0};
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(this->lumens(world, lights[i].power), exact[i], near(exact[i])) << i;
    EXPECT_EQ(lights[i].is_far(), i >= 3);
  }
  EXPECT_NEAR(this->lumens(world, lights[0].intensity), 60.0, near(60.0));
  EXPECT_NEAR(lights[0].cone.axis.y, -1.0, 1e-6);
  EXPECT_NEAR(lights[0].cone.cos_half, 1.0, 1e-6);
  EXPECT_FALSE(lights[0].two_sided);
  EXPECT_TRUE(lights[1].two_sided);
}

// The left half of a picture is white, the rest black; the lamp shows all of it, or some of its black part.
TYPED_TEST(LightEmissionsTest, ATextureDimsItsLamp) {
  const auto power = [&](float low_u, float high_u) {
    Scene scene;
    place(scene, {{-1, 0, -1}, {0, 0, 2}, {2, 0, 0}}, matte(glm::vec3(0.5F)));
    place(scene, {{-0.5, 1, -0.5}, {1, 0, 0}, {0, 0, 1}}, lamp(glm::vec3(10.0F)));
    scene.images.push_back({2, 1, {255, 255, 255, 255, 0, 0, 0, 255}});
    scene.materials.back().emission_texture.image = 0;
    scene.materials.back().emission_texture.nearest = true;
    scene.meshes.back().primitives.front().uv[0] = {{low_u, 0}, {high_u, 0}, {high_u, 1}, {low_u, 1}};
    scene.cameras.push_back(look_at({0.0, 1.0, 3.0}, glm::dvec3(0.0)));
    const auto world = bake_world<TypeParam>(scene);
    return this->lumens(world, light_emissions(world).front().power);
  };
  EXPECT_NEAR(power(0.0F, 1.0F), 0.5 * kPi * 10.0, 1e-3);
  EXPECT_NEAR(power(0.8F, 0.9F), kPi * 10.0 / 256.0, 1e-3) << "small bright marks may have been overlooked";
}

// Variance of one shadow ray's irradiance, relative to its square, over what the camera sees of a scene.
template <class N>
double relative_variance(const World<N>& world, const std::vector<Receiver<N>>& receivers, LightSelection how,
                         LightPoints points) {
  using Unit = typename N::Unit;
  constexpr int kSamples = 250;
  RandomInputs random(1);
  const auto bits = [&] { return static_cast<std::uint32_t>(random.bits() >> 32); };
  double sum_of_variances = 0.0;
  double sum_of_squares = 0.0;
  for (const Receiver<N>& receiver : receivers) {
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < kSamples; ++i) {
      const std::uint32_t choice = bits();
      const std::uint32_t part = bits();
      const Unit u = N::unit_from_bits(bits());
      const Unit v = N::unit_from_bits(bits());
      const auto chosen = world.light_selectors.select(how, receiver, choice);
      if (!chosen) continue;
      const auto light = world.lights.sample(chosen->light, points, receiver.position, part, u, v);
      if (!light || !(dot(light->wi, receiver.normal) > 0)) continue;
      const Vec3<typename N::Length> way = *light->end - receiver.position;
      const Ray<N> ray{receiver.position, normalize(way), length(way)};
      std::uint8_t occluded = 0;
      world.occluded({&ray, 1}, {&occluded, 1});
      if (occluded != 0) continue;
      const double L = luminance<double>(
          to_host(world.emitted(light->triangle, light->barycentric.x, light->barycentric.y)));
      const double x = L * to_host(dot(light->wi, receiver.normal)) / to_host(chosen->prob * light->pdf_w);
      sum += x / kSamples;
      squares += x * x / kSamples;
    }
    sum_of_variances += squares - sum * sum;
    sum_of_squares += sum * sum;
  }
  return sum_of_variances / sum_of_squares;
}

TYPED_TEST(LightEmissionsTest, InAHallOfLampsPowerBeatsUniformAndTheTreeBeatsPower) {
  using Unit = typename TypeParam::Unit;
  const Scene scene = import_gltf(source_file("scenes/lamps.gltf"));
  const auto world = bake_world<TypeParam>(scene);
  constexpr int kWidth = 36;
  constexpr int kHeight = 24;
  const auto camera = bake_camera(scene.cameras.front(), world, kWidth, kHeight);
  std::vector<Receiver<TypeParam>> receivers;
  for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
    const Ray<TypeParam> ray = camera.ray(i % kWidth, i / kWidth, Unit(0.5), Unit(0.5));
    Hit<TypeParam> hit{};
    world.closest({&ray, 1}, {&hit, 1});
    if (!hit || world.triangles[hit.triangle].light != kNoLight) continue;
    const auto point = world.surface_point(hit);
    const bool behind = dot(point.geometric_normal, ray.direction) > 0;
    const Vec3<Unit> facing = behind ? -point.geometric_normal : point.geometric_normal;
    receivers.push_back({point.position + facing * ray_offset<TypeParam>(), facing, false});
  }
  ASSERT_GT(receivers.size(), 700U);
  const auto variance = [&](LightSelection how, LightPoints points) {
    return relative_variance(world, receivers, how, points);
  };
  const double uniform = variance(LightSelection::kUniform, LightPoints::kArea);
  const double power = variance(LightSelection::kPower, LightPoints::kArea);
  const double tree = variance(LightSelection::kTree, LightPoints::kArea);
  const double best = variance(LightSelection::kTree, LightPoints::kSolidAngle);
  EXPECT_GT(uniform, 2.5 * power);
  EXPECT_GT(power, 1.6 * tree);
  EXPECT_GT(tree, 2.0 * best);
  for (const auto& [name, ratio] : {std::pair("uniform_over_power", uniform / power),
                                    {"power_over_tree", power / tree},
                                    {"area_over_solid_angle", tree / best}}) {
    this->RecordProperty(name, std::to_string(ratio));
  }
}

}  // namespace
}  // namespace vitrine
