// From a scene to its world: what is where, how bright, and which way it faces.
#include "scene/bake.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "number_systems.h"
#include "scene/input_error.h"
#include "scene/made_scene.h"

namespace vitrine {
namespace {

Scene one_quad(const glm::dmat4& to_world = glm::dmat4(1.0)) {
  Scene scene;
  place(scene, {{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, matte(glm::vec3(0.5F)), to_world);
  scene.cameras.push_back(look_at({0, 0, 3}, {0, 0, 0}));
  return scene;
}

template <class N>
class Bake : public testing::Test {
 protected:
  /// A vertex in metres.
  static glm::dvec3 position(const World<N>& world, std::size_t i) {
    return to_host(world.bvh.positions()[i]) / world.scale + world.center;
  }
  static double nits(const World<N>& world, typename N::Radiance radiance) {
    return std::ldexp(to_host(radiance), world.exponent);
  }
  static void expect_near(const glm::dvec3& found, const glm::dvec3& expected, double tolerance) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], tolerance) << c;
  }
};
TYPED_TEST_SUITE(Bake, NumberSystems, NumberSystemNames);

TYPED_TEST(Bake, FitsEverythingARayMayStartFromIntoTheUnitBox) {
  Scene scene = one_quad(glm::translate(glm::dmat4(1.0), glm::dvec3(100.0, 20.0, -7.0)));
  scene.cameras.front() = look_at({103, 25, 9}, {100, 20, -7});
  scene.lights.push_back(point_light(glm::vec3(1.0F), {80.0, 20.0, -7.0}));
  const auto world = bake_world<TypeParam>(scene);
  for (const glm::dvec3& p : {glm::dvec3(101, 21, -7), glm::dvec3(103, 25, 9), glm::dvec3(80, 20, -7)}) {
    const glm::dvec3 baked = glm::abs((p - world.center) * world.scale);
    EXPECT_LE(std::max({baked.x, baked.y, baked.z}), 1.0);
  }
  EXPECT_GT(20.0 * world.scale, 0.9);  // and no smaller than needed
  this->expect_near(this->position(world, 0), {99, 19, -7}, 1e-5);
  this->expect_near(this->position(world, 2), {101, 21, -7}, 1e-5);
}

TYPED_TEST(Bake, TurnsNormalsWithTheirSurface) {
  // Stretched: a normal is turned by the inverse transpose. (Its surface: z = x after the shear.)
  glm::dmat4 shear(1.0);
  shear[0][2] = 1.0;
  const auto world = bake_world<TypeParam>(one_quad(shear));
  const glm::dvec3 expected = glm::normalize(glm::dvec3(-1, 0, 1));
  for (const auto& info : world.triangles) this->expect_near(to_host(info.normal), expected, 1e-6);
  for (const auto& normal : world.normals) this->expect_near(to_host(normal), expected, 1e-6);
}

TYPED_TEST(Bake, MirroringKeepsTheFrontInFront) {
  const auto world = bake_world<TypeParam>(one_quad(glm::scale(glm::dmat4(1.0), glm::dvec3(-2, 1, 1))));
  for (const auto& info : world.triangles) this->expect_near(to_host(info.normal), {0, 0, 1}, 1e-6);
  for (const auto& normal : world.normals) this->expect_near(to_host(normal), {0, 0, 1}, 1e-6);
  const auto turned = bake_world<TypeParam>(one_quad(glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, -1))));
  for (const auto& info : turned.triangles) this->expect_near(to_host(info.normal), {0, 0, -1}, 1e-6);
  for (const auto& normal : turned.normals) this->expect_near(to_host(normal), {0, 0, -1}, 1e-6);
}

TYPED_TEST(Bake, LeavesOutTrianglesWithoutArea) {
  Scene scene = one_quad();
  Primitive& primitive = scene.meshes.front().primitives.front();
  primitive.triangles.emplace_back(0, 0, 1);
  primitive.triangles.emplace_back(2, 1, 2);
  scene.materials.front().emission = glm::vec3(1.0F);
  const auto world = bake_world<TypeParam>(scene);
  EXPECT_EQ(world.triangles.size(), 2U);
  EXPECT_EQ(world.bvh.triangles().size(), 2U);
  ASSERT_EQ(world.lights.meshes.size(), 1U);
  EXPECT_EQ(world.lights.meshes.front().triangles().size(), 2U);
}

TYPED_TEST(Bake, EveryEmissivePrimitiveOfAnInstanceIsALight) {
  Scene scene = one_quad();
  place(scene, {{-1, -1, 1}, {1, 0, 0}, {0, 1, 0}}, lamp({2.0F, 1.0F, 0.5F}));
  scene.instances.push_back(scene.instances.back());
  scene.instances.back().to_world = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, 1));
  scene.lights.push_back(sun(glm::vec3(7.0F), {0, -1, 0}));
  scene.lights.push_back(point_light(glm::vec3(3.0F), {0, 1, 0}));
  scene.environment = Environment{};
  const auto world = bake_world<TypeParam>(scene);
  EXPECT_EQ(world.lights.meshes.size(), 2U);
  EXPECT_EQ(world.lights.size(), 5U);
  int emitting = 0;
  for (std::size_t i = 0; i < world.triangles.size(); ++i) {
    const auto& info = world.triangles[i];
    if (info.light == kNoLight) continue;
    ++emitting;
    const auto& light = world.lights.meshes[info.light].triangles()[info.light_triangle];
    EXPECT_EQ(light.triangle, i);
    EXPECT_NEAR(light.area, 0.5 * world.scale * world.scale, 1e-6);
    const auto zero = from_host<typename TypeParam::Unit>(0.0);
    EXPECT_NEAR(this->nits(world, world.emitted(static_cast<std::uint32_t>(i), zero, zero).x), 2.0, 1e-6);
  }
  EXPECT_EQ(emitting, 4);
}

TYPED_TEST(Bake, TheBrightestLightIsAboutOne) {
  for (const float nits : {1e-6F, 0.3F, 1.0F, 1e9F}) {
    Scene scene = one_quad();
    place(scene, {{-1, -1, 1}, {1, 0, 0}, {0, 1, 0}}, lamp(glm::vec3(nits)));
    const auto world = bake_world<TypeParam>(scene);
    const double brightest = static_cast<double>(nits) * std::ldexp(1.0, -world.exponent);
    EXPECT_GT(brightest, 0.49) << nits;
    EXPECT_LE(brightest, 1.0) << nits;
  }
}

TYPED_TEST(Bake, CandelaAreScaledWithTheLengths) {
  Scene scene = one_quad();
  scene.lights.push_back(point_light({10.0F, 20.0F, 40.0F}, {0.0, 0.0, 2.0}));
  const auto world = bake_world<TypeParam>(scene);
  const auto& light = world.lights.points.front();
  const double back = 1.0 / (world.scale * world.scale);
  EXPECT_NEAR(this->nits(world, light.intensity.x) * back, 10.0, 1e-4);
  EXPECT_NEAR(this->nits(world, light.intensity.z) * back, 40.0, 1e-4);
}

TYPED_TEST(Bake, RefusesWhatHasNoExtent) {
  Scene empty;
  empty.file = "empty.gltf";
  EXPECT_THROW(bake_world<TypeParam>(empty), InputError);
  Scene point = one_quad(glm::scale(glm::dmat4(1.0), glm::dvec3(0.0)));
  point.cameras.clear();
  EXPECT_THROW(bake_world<TypeParam>(point), InputError);
  EXPECT_THROW(bake_world<TypeParam>(one_quad(glm::scale(glm::dmat4(1.0), glm::dvec3(HUGE_VAL)))),
               InputError);
  EXPECT_THROW(bake_world<TypeParam>(one_quad(glm::scale(glm::dmat4(1.0), glm::dvec3(NAN)))), InputError);
}

TYPED_TEST(Bake, RefusesALightTooFarAwayByTheFilesName) {
  Scene scene = one_quad();
  scene.file = "far.gltf";
  scene.lights.push_back(point_light(glm::vec3(1.0F), {0.0, 0.0, 1e5}));
  try {
    bake_world<TypeParam>(scene);
    FAIL() << "baked";
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("far.gltf: ")) << error.what();
    EXPECT_NE(std::string(error.what()).find("; "), std::string::npos) << error.what();
  }
}

// A vertex without a colour is white, also where other meshes of the scene have colours.
TYPED_TEST(Bake, VertexColoursOfOneMeshDoNotTintAnother) {
  Scene scene = one_quad();
  place(scene, {{-1, -1, 1}, {1, 0, 0}, {0, 1, 0}}, matte(glm::vec3(1.0F)));
  scene.meshes.back().primitives.front().colors.assign(4, glm::vec3(0.25F, 0.5F, 0.75F));
  place(scene, {{-1, -1, 2}, {1, 0, 0}, {0, 1, 0}}, matte(glm::vec3(1.0F)));
  const auto world = bake_world<TypeParam>(scene);
  const auto third = from_host<typename TypeParam::Unit>(1.0 / 3.0);
  for (std::uint32_t i = 0; i < 6; ++i) {
    const bool tinted = i == 2 || i == 3;
    this->expect_near(to_host(world.coordinates(i, third, third).color),
                      tinted ? glm::dvec3(0.25, 0.5, 0.75) : glm::dvec3(1.0), 1e-6);
  }
}

TYPED_TEST(Bake, TextureCoordinatesAreTransformedPerUse) {
  Scene scene = one_quad();
  scene.images.push_back({1, 1, {255, 255, 255, 255}});
  Primitive& primitive = scene.meshes.front().primitives.front();
  primitive.uv[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Material& material = scene.materials.front();
  material.base_color_texture.image = 0;
  material.emission_texture.image = 0;
  material.emission_texture.transform = glm::mat3(2, 0, 0, 0, 3, 0, 0.5F, 0.25F, 1);  // by columns
  material.transmission_texture.image = 0;
  const auto world = bake_world<TypeParam>(scene);
  ASSERT_EQ(world.uv_sets.size(), 2U);  // base colour and transmission share one
  const auto zero = from_host<typename TypeParam::Unit>(0.0);
  const auto one = from_host<typename TypeParam::Unit>(1.0);
  const auto at = world.coordinates(0, zero, one);  // the third corner, uv (1, 1)
  const auto& baked = world.materials.front();
  EXPECT_EQ(baked.base_color_texture->uv_set, baked.transmission_texture->uv_set);
  EXPECT_NEAR(to_host(at.uv(baked.base_color_texture->uv_set).x), 1.0, 1e-4);
  EXPECT_NEAR(to_host(at.uv(baked.emission_texture->uv_set).x), 2.5, 1e-4);
  EXPECT_NEAR(to_host(at.uv(baked.emission_texture->uv_set).y), 3.25, 1e-4);
}

}  // namespace
}  // namespace vitrine
