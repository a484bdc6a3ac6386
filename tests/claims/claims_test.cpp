// Every claim of the lecture holds at equal samples.
#include "claims/claims.h"

#include <cstddef>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include "claims/measure.h"

namespace vitrine {
namespace {

constexpr int kSize = 32;
constexpr std::uint32_t kSamples = 16;
constexpr int kSeeds = 16;

class Claims : public testing::TestWithParam<std::size_t> {};

TEST_P(Claims, HoldAtEqualSamples) {
  const Claim& claim = claims()[GetParam()];
  const Scene scene = project_scene(std::string(claim.scene));
  const auto baked = bake(scene, Numbers::kFloat);
  const auto better = render_seeds(*baked, sampling(claim.better), kSize, kSamples, 1, kSeeds);
  const auto worse = render_seeds(*baked, sampling(claim.worse), kSize, kSamples, 1000, kSeeds);
  const Mask mask =
      claim.material.empty() ? Mask(kSize * kSize, true) : see_material(scene, claim.material, kSize);
  const std::vector<double> weights = pixel_weights(mean_picture(better), mask);
  const double ratio = relative_variance(better, weights) / relative_variance(worse, weights);
  std::cout << "  " << claim.scene << ": " << claim.better << " has " << ratio << " times the variance of "
            << claim.worse << '\n';
  EXPECT_LT(ratio, claim.at_most) << claim.section;
}

INSTANTIATE_TEST_SUITE_P(Lecture, Claims, testing::Range<std::size_t>(0, claims().size()),
                         [](const auto& test) {
                           const Claim& claim = claims()[test.param];
                           std::string name = std::string(claim.scene) + '_' + std::string(claim.better) +
                                              "_over_" + std::string(claim.worse) + '_' +
                                              std::string(claim.material);
                           std::ranges::replace_if(
                               name, [](char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace vitrine
