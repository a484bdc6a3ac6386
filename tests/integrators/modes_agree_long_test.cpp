// The same as modes_agree_test.cpp with so many samples that small deviations show, and smaller tiles can be
// told apart, and with every value of each parameter on every scene.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "integrators/agreement.h"

namespace vitrine {
namespace {

class ModesAgreeLong : public testing::TestWithParam<std::string> {};

TEST_P(ModesAgreeLong, OnAllLight) {
  expect_all_same(
      render_all(project_scene(GetParam()), judgeable(mode_ways(), GetParam()), {.batch_samples = 6}));
}

TEST_P(ModesAgreeLong, WithEveryParameter) {
  std::vector<Way> ways;
  for (const Parameter& parameter : parameters()) {
    for (Way& way : parameter_ways(parameter)) {
      if (way.parts.shadow_rays <= 16) ways.push_back(std::move(way));
    }
  }
  expect_all_same(render_all(project_scene(GetParam()), ways, {.size = 16, .batch_samples = 2}));
}

INSTANTIATE_TEST_SUITE_P(Scenes, ModesAgreeLong, testing::ValuesIn(project_scenes()),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace vitrine
