// Every unbiased mode shows the same picture, in both number systems, on each of the project's scenes that it
// can render: direct light alone, where the tails are short and small tiles can be told apart, and all light.
// And so does every value of each parameter.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "integrators/agreement.h"

namespace vitrine {
namespace {

class ModesAgree : public testing::TestWithParam<std::string> {};

TEST_P(ModesAgree, OnDirectLight) {
  expect_all_same(render_all(project_scene(GetParam()), judgeable(mode_ways(), GetParam()),
                             {.size = 16, .batch_samples = 4, .max_depth = 1}));
}

TEST_P(ModesAgree, OnAllLight) {
  expect_all_same(render_all(project_scene(GetParam()), judgeable(mode_ways(), GetParam()),
                             {.size = 16, .batch_samples = 4}));
}

INSTANTIATE_TEST_SUITE_P(Scenes, ModesAgree, testing::ValuesIn(project_scenes()),
                         [](const auto& test) { return test_name(test.param); });

class ParametersAgree : public testing::TestWithParam<std::string> {};

TEST_P(ParametersAgree, OnAllLight) {
  std::vector<Way> ways = parameter_ways(*find_parameter(GetParam()));
  std::erase_if(ways, [](const Way& way) { return way.parts.shadow_rays > 16; });  // they take too long
  ASSERT_FALSE(ways.empty());
  for (const char* scene : {"cornell-spheres", "lamps"}) {
    SCOPED_TRACE(scene);
    expect_all_same(render_all(project_scene(scene), ways, {.size = 16, .batch_samples = 1}));
  }
}

std::vector<std::string> parameter_names() {
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters()) names.emplace_back(parameter.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Parameters, ParametersAgree, testing::ValuesIn(parameter_names()),
                         [](const auto& test) { return test_name(test.param); });

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
  const Agreement agreement = render_all(scene, mode_ways(), {.batch_samples = 4});
  for (const auto& both : agreement.ways) {
    for (const Rendering& rendering : both) {
      EXPECT_LT(rendering.finest_fit, rendering.cuts.size()) << rendering.name << " cannot be judged";
    }
  }
  expect_all_same(agreement);
}

}  // namespace
}  // namespace vitrine
