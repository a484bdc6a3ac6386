// The same as modes_agree_test.cpp with so many samples that small deviations show, and smaller tiles can be
// told apart.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "integrators/agreement.h"

namespace vitrine {
namespace {

class ModesAgreeLong : public testing::TestWithParam<std::string> {};

TEST_P(ModesAgreeLong, OnAllLight) {
  expect_all_same(render_all_ways(project_scene(GetParam()), {.batch_samples = 32}));
}

INSTANTIATE_TEST_SUITE_P(Scenes, ModesAgreeLong, testing::ValuesIn(project_scenes()), [](const auto& test) {
  std::string name = test.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace vitrine
