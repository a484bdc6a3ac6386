// Several shadow rays a vertex and several directions a vertex: the same mean, less variance, and exactly the
// number of rays that was asked for. Lecture: "Next Event Estimation Performance", 1 to 256 samples.
#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "scene/made_scene.h"
#include "scene/round_room.h"
#include "statistics/picture.h"

namespace vitrine {
namespace {

/// A matte floor under `lamps` square lamps, seen from above between them: all noise is that of shadow rays.
std::unique_ptr<const BakedScene> floor_under_lamps(int lamps, Numbers numbers) {
  Scene scene;
  place(scene, {{-1, 0, 1}, {2, 0, 0}, {0, 0, -2}}, matte(glm::vec3(0.6F)));
  for (int i = 0; i < lamps; ++i) {
    Material lamp = matte(glm::vec3(0.0F));
    lamp.emission = glm::vec3(10.0F);
    place(scene, {{-0.9 + 0.5 * i, 0.5, -0.9}, {0.4, 0, 0}, {0, 0, 0.4}}, lamp);
  }
  scene.cameras.push_back(look_at({0.0, 0.4, 0.9}, {0.0, 0.0, 0.2}, 0.2));
  return bake(scene, numbers);
}

TraceStats trace_floor(const BakedScene& scene, const SamplingParts& parts, Film& film) {
  const auto renderer = scene.make_renderer({.mode = find_mode("nee"),
                                             .parts = parts,
                                             .width = film.width(),
                                             .height = film.height(),
                                             .max_depth = 1});
  const std::atomic<bool> cancel{false};
  return renderer->trace({0, 0, film.width(), film.height()}, {0, 16}, film, cancel);
}

double variance_of_direct_light(const BakedScene& scene, const SamplingParts& parts) {
  const TilePicture picture =
      render_tiles(scene, *find_mode("nee"),
                   {.size = 8, .batches = 64, .batch_samples = 1, .max_depth = 1, .parts = parts});
  double sum = 0.0;
  for (int tile = 0; tile < picture.tiles(); ++tile) sum += picture.estimate(tile, 1).variance;
  return sum;
}

class Splitting : public testing::TestWithParam<Numbers> {};

TEST_P(Splitting, ShadowRaysDivideTheVariance) {
  const auto scene = floor_under_lamps(1, GetParam());
  SamplingParts parts = find_mode("nee")->parts;
  const double one = variance_of_direct_light(*scene, parts);
  for (const int rays : {4, 16, 64}) {
    parts.shadow_rays = rays;
    const double ratio = one / variance_of_direct_light(*scene, parts);
    // Independent points, so about `rays` times less; what varies over the pixel stays.
    EXPECT_GT(ratio, 0.6 * rays) << rays;
    EXPECT_LT(ratio, 1.6 * rays) << rays;
  }
}

TEST_P(Splitting, ManyLightsShareTheRays) {
  constexpr int kLamps = 3;
  const auto scene = floor_under_lamps(kLamps, GetParam());
  const auto rays_a_sample = [&](LightSelection lights, int shadow_rays) {
    SamplingParts parts = find_mode("nee")->parts;
    parts.lights = lights;
    parts.shadow_rays = shadow_rays;
    Film film(4, 4, 0);  // sees nothing but the floor, which sees the front of every lamp
    const TraceStats stats = trace_floor(*scene, parts, film);
    return static_cast<double>(stats.rays) / static_cast<double>(stats.samples);
  };
  // One ray from the eye, one that is scattered, and the shadow rays.
  EXPECT_NEAR(rays_a_sample(LightSelection::kUniform, 1), 3.0, 0.01);
  EXPECT_NEAR(rays_a_sample(LightSelection::kUniform, 6), 8.0, 0.01);
  EXPECT_NEAR(rays_a_sample(LightSelection::kAll, 1), 2.0 + kLamps, 0.01) << "at least one each";
  EXPECT_NEAR(rays_a_sample(LightSelection::kAll, 6), 8.0, 0.01);
}

TEST_P(Splitting, AskingAllLightsIsBetterThanOne) {
  const auto scene = floor_under_lamps(3, GetParam());
  SamplingParts one = find_mode("nee")->parts;
  one.shadow_rays = 3;
  SamplingParts all = one;
  all.lights = LightSelection::kAll;
  EXPECT_LT(variance_of_direct_light(*scene, all), variance_of_direct_light(*scene, one));
}

// Le / (1 - albedo), however paths are split, also where that is beyond the limit of branches.
TEST_P(Splitting, RadianceSamplesKeepTheMean) {
  const glm::dvec3 emission(0.4, 0.25, 0.1);
  Scene room;
  Material wall = matte(glm::vec3(0.5F));
  wall.emission = emission;
  place_round_room(room, 6, wall);
  room.cameras.push_back(look_at({0.3, 0.2, 0.5}, {0.0, 0.0, 0.0}));
  const auto scene = bake(room, GetParam());
  for (const char* mode : {"basic", "nee", "mis"}) {
    for (const int directions : {2, 5, 32}) {
      SamplingParts parts = find_mode(mode)->parts;
      parts.radiance_samples = directions;
      const TilePicture picture =
          render_tiles(*scene, *find_mode(mode), {.size = 4, .batch_samples = 2, .parts = parts});
      for (int c = 0; c < 3; ++c) {
        const double exact = 2.0 * emission[c];
        EXPECT_LT(std::abs(z_score(picture.whole(c), exactly(exact), 1e-5 * exact)), sidak_limit(54))
            << mode << ' ' << directions << ": " << picture.whole(c).mean;
      }
    }
  }
}

// In b directions from the first vertex, and in b from each of those.
TEST_P(Splitting, EveryVertexSplits) {
  Scene room;
  place_round_room(room, 6, matte(glm::vec3(0.5F)));
  room.cameras.push_back(look_at({0.3, 0.2, 0.5}, {0.0, 0.0, 0.0}));
  const auto scene = bake(room, GetParam());
  SamplingParts parts = find_mode("basic")->parts;
  parts.radiance_samples = 3;
  Film film(4, 4, 0);
  const auto renderer = scene->make_renderer(
      {.mode = find_mode("basic"), .parts = parts, .width = 4, .height = 4, .max_depth = 2});
  const std::atomic<bool> cancel{false};
  const TraceStats stats = renderer->trace({0, 0, 4, 4}, {0, 8}, film, cancel);
  EXPECT_EQ(stats.rays, stats.samples * (1 + 3 + 9));
}

INSTANTIATE_TEST_SUITE_P(Numbers, Splitting, testing::Values(Numbers::kFloat, Numbers::kFixed),
                         [](const auto& test) { return std::string(numbers_name(test.param)); });

}  // namespace
}  // namespace vitrine
