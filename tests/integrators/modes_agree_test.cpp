// Every mode shows the same picture, in both number systems, on each of the project's scenes that it can
// render: direct light alone, where the tails are short and small tiles can be told apart, and all light.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "integrators/agreement.h"

namespace vitrine {
namespace {

class ModesAgree : public testing::TestWithParam<std::string> {};

TEST_P(ModesAgree, OnDirectLight) {
  expect_all_same(render_all_ways(project_scene(GetParam()), {.batch_samples = 4, .max_depth = 1}));
}

TEST_P(ModesAgree, OnAllLight) {
  expect_all_same(render_all_ways(project_scene(GetParam()), {.batch_samples = 4}));
}

INSTANTIATE_TEST_SUITE_P(Scenes, ModesAgree, testing::ValuesIn(project_scenes()), [](const auto& test) {
  std::string name = test.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

// Met by chance, the small lamps in the smooth plates stay too rare to tell a low mean from a wrong one. With
// rough plates and fewer nits from larger lamps the same scene can be judged both ways.
TEST(ModesAgreeWhenSoftened, OnThePlates) {
  Scene scene = project_scene("plates");
  for (Material& material : scene.materials) material.roughness = std::max(material.roughness, 0.4F);
  for (Instance& instance : scene.instances) {
    const double size = glm::length(glm::dvec3(instance.to_world[0]));
    const double wanted = 0.2;
    if (size >= wanted) continue;
    for (int axis = 0; axis < 3; ++axis) instance.to_world[axis] *= wanted / size;
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
      scene.materials[static_cast<std::size_t>(primitive.material)].emission *=
          static_cast<float>(size * size / (wanted * wanted));
    }
  }
  const std::vector<Rendering> renderings = render_all_ways(scene, {.batch_samples = 4});
  for (const Rendering& rendering : renderings) {
    EXPECT_LT(rendering.finest_fit, rendering.cuts.size()) << rendering.name << " cannot be judged";
  }
  expect_all_same(renderings);
}

}  // namespace
}  // namespace vitrine
