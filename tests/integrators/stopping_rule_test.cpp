// When paths end. A fixed depth leaves out exactly the longer paths; each roulette has the true mean, and the
// mean path length that its probabilities promise.
#include <cmath>
#include <iostream>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "integrators/parameters.h"
#include "scene/made_scene.h"
#include "scene/round_room.h"
#include "statistics/picture.h"

namespace vitrine {
namespace {

const glm::dvec3 kLe(0.4, 0.25, 0.1);

/// A round room that emits Le and reflects `albedo`: every direction shows Le / (1 - albedo).
std::unique_ptr<const BakedScene> round_furnace(float albedo, Numbers numbers) {
  Scene room;
  Material wall = matte(glm::vec3(albedo));
  wall.emission = kLe;
  place_round_room(room, 6, wall);
  room.cameras.push_back(look_at({0.3, 0.2, 0.5}, {0.0, 0.0, 0.0}));
  return bake(room, numbers);
}

SamplingParts with_rule(const char* mode, const std::string& rule) {
  SamplingParts parts = find_mode(mode)->parts;
  EXPECT_TRUE(find_parameter("roulette")->set(parts, rule)) << rule;
  return parts;
}

/// Rays from the eye and from surfaces, a sample.
double mean_path_length(const BakedScene& scene, const SamplingParts& parts) {
  constexpr int kSize = 32;
  const auto renderer =
      scene.make_renderer({.mode = find_mode("basic"), .parts = parts, .width = kSize, .height = kSize});
  Film film = renderer->make_film();
  const std::atomic<bool> cancel{false};
  const TraceStats stats = renderer->trace({0, 0, kSize, kSize}, {0, 64}, film, cancel);
  return static_cast<double>(stats.rays) / static_cast<double>(stats.samples);
}

class StoppingRules : public testing::TestWithParam<Numbers> {};

TEST_P(StoppingRules, FixedDepthLeavesOutTheRest) {
  const auto scene = round_furnace(0.5F, GetParam());
  for (const char* mode : {"basic", "nee", "mis"}) {
    double worst = 1.0;
    for (const int depth : {0, 1, 2, 4, 8}) {
      const SamplingParts parts = with_rule(mode, "fixed-depth:" + std::to_string(depth));
      EXPECT_FALSE(bias(parts).empty());
      const TilePicture picture =
          render_tiles(*scene, *find_mode(mode), {.size = 16, .batch_samples = 2, .parts = parts});
      const double missing = std::ldexp(1.0, -depth);
      for (int c = 0; c < 3; ++c) {
        const double exact = kLe[c] * (2.0 - missing);
        EXPECT_LT(std::abs(z_score(picture.whole(c), exactly(exact), 1e-5 * exact)), sidak_limit(90))
            << mode << " depth " << depth;
      }
      const double deviation = 1.0 - picture.whole(0).mean / (2.0 * kLe[0]);
      EXPECT_LT(deviation, worst) << mode << " depth " << depth << ": the bias does not shrink";
      worst = deviation;
    }
  }
}

TEST_P(StoppingRules, RouletteHasTheTrueMean) {
  const auto scene = round_furnace(0.5F, GetParam());
  for (const char* mode : {"basic", "mis"}) {
    for (const char* rule : {"constant:0.9", "constant:0.5", "constant:0.1", "reflectance", "throughput"}) {
      const SamplingParts parts = with_rule(mode, rule);
      EXPECT_TRUE(bias(parts).empty());
      const TilePicture picture = render_tiles(
          *scene, *find_mode(mode), {.size = 16, .batches = 64, .batch_samples = 16, .parts = parts});
      for (int c = 0; c < 3; ++c) {
        const double exact = 2.0 * kLe[c];
        EXPECT_LT(std::abs(z_score(picture.whole(c), exactly(exact), 1e-5 * exact)), sidak_limit(60))
            << mode << ' ' << rule << ": " << picture.whole(c).mean << ", exactly " << exact;
      }
    }
  }
}

// A path that goes on with probability p has 1 / (1 - p) rays in the mean.
TEST_P(StoppingRules, PathsAreAsLongAsTheProbabilitiesSay) {
  const auto scene = round_furnace(0.75F, GetParam());
  const auto expect_length = [&](const char* rule, double prob) {
    const double length = mean_path_length(*scene, with_rule("basic-cosine", rule));
    std::cout << "  " << rule << ": " << length << " rays a path\n";
    // The number of rays is geometric with variance p / (1 - p)^2.
    const double error = std::sqrt(prob) / (1.0 - prob) / std::sqrt(32.0 * 32.0 * 64.0);
    EXPECT_NEAR(length, 1.0 / (1.0 - prob), 4.5 * error) << rule;
  };
  expect_length("constant:0.9", 0.9);
  expect_length("constant:0.1", 0.1);
  expect_length("reflectance", 0.75);
  // By throughput: 1 for the first two events, then 0.75^3, and from then on 0.75 of what is left by roulette
  // is 1 again: beta is 1 after a test that was survived.
  const double first = std::pow(0.75, 3);
  const double length = mean_path_length(*scene, with_rule("basic-cosine", "throughput"));
  EXPECT_NEAR(length, 3.0 + first / (1.0 - 0.75), 0.04);
  EXPECT_NEAR(mean_path_length(*scene, with_rule("basic-cosine", "fixed-depth:4")), 5.0, 1e-9);
}

// "Darker patches will statistically shorten paths."
TEST_P(StoppingRules, DarkerSurfacesShortenPaths) {
  const SamplingParts parts = with_rule("basic", "reflectance");
  double longest = 1.0;
  for (const float albedo : {0.1F, 0.4F, 0.8F}) {
    const double length = mean_path_length(*round_furnace(albedo, GetParam()), parts);
    EXPECT_GT(length, longest * 1.05) << albedo;
    longest = length;
  }
}

INSTANTIATE_TEST_SUITE_P(Numbers, StoppingRules, testing::Values(Numbers::kFloat, Numbers::kFixed),
                         [](const auto& test) { return std::string(numbers_name(test.param)); });

// In a room of many surfaces; lengths are for the reader.
TEST(StoppingRulesOnCornell, PrintTheMeanPathLength) {
  const auto scene = bake(project_scene("cornell"), Numbers::kFloat);
  double before = 1e9;
  for (const char* rule : {"constant:0.9", "throughput", "reflectance", "constant:0.1"}) {
    const double length = mean_path_length(*scene, with_rule("basic", rule));
    std::cout << "  " << rule << ": " << length << " rays a path\n";
    EXPECT_GE(length, 1.0);
    EXPECT_LT(length, before) << rule;
    before = length;
  }
}

}  // namespace
}  // namespace vitrine
