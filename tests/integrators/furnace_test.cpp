// Furnaces: closed rooms that emit Le everywhere and reflect half of what arrives. After k scattering events
// every direction shows Le (1 + 1/2 + ... + 1/2^k), after all of them 2 Le, whatever the room's shape. A
// cosine or a bounce that is missing, a roulette that does not divide, weights that do not sum to one: all
// change it.
#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "scene/made_scene.h"
#include "scene/round_room.h"
#include "statistics/picture.h"

namespace vitrine {
namespace {

const glm::dvec3 kLe(0.4, 0.25, 0.1);  // of scenes/furnace.gltf
constexpr double kBound = 0.002;
constexpr double kSafety = 3.5;  // standard errors within the bound, so that chance does not decide

void expect_within_bound(const TilePicture& picture, const glm::dvec3& exact) {
  for (int c = 0; c < 3; ++c) {
    const Estimate shown = picture.whole(c);
    EXPECT_LT(kSafety * std::sqrt(shown.variance), kBound * exact[c]) << "too few samples to judge";
    EXPECT_NEAR(shown.mean, exact[c], kBound * exact[c]) << "channel " << c;
  }
}

class Furnace : public testing::TestWithParam<Numbers> {};

// Not by next event estimation: where two walls meet its cos cos' / d^2 has no bound and its variance no end,
// see furnace_corners_test.cpp.
TEST_P(Furnace, ShowsTwiceItsEmission) {
  const auto scene = bake(project_scene("furnace"), GetParam());
  for (const Mode& mode : modes()) {
    if (mode.parts.direct == DirectLight::kNextEvent) continue;
    SCOPED_TRACE(mode.key);
    expect_within_bound(render_tiles(*scene, mode, {.batches = 64, .batch_samples = 24}), 2.0 * kLe);
  }
}

std::unique_ptr<const BakedScene> round_furnace(unsigned rings, Numbers numbers) {
  Scene room;
  Material wall = matte(glm::vec3(0.5F));
  wall.emission = kLe;
  place_round_room(room, rings, wall);
  room.cameras.push_back(look_at({0.3, 0.2, 0.5}, {0.0, 0.0, 0.0}));
  return bake(room, numbers);
}

// Within a sphere cos cos' / d^2 is a constant, and next event estimation the best of all.
TEST_P(Furnace, ShowsTwiceItsEmissionInTheRound) {
  const auto scene = round_furnace(16, GetParam());
  for (const Mode& mode : modes()) {
    if (mode.parts.direct == DirectLight::kByChance) continue;
    SCOPED_TRACE(mode.key);
    expect_within_bound(render_tiles(*scene, mode, {.batch_samples = 16}), 2.0 * kLe);
  }
}

TEST_P(Furnace, EveryBounceAddsHalfOfTheOneBefore) {
  const auto scene = round_furnace(6, GetParam());
  for (const Mode& mode : modes()) {
    for (const int depth : {0, 1, 2, 4, 8}) {
      const TilePicture picture = render_tiles(*scene, mode, {.batch_samples = 2, .max_depth = depth});
      const glm::dvec3 exact = kLe * (2.0 - std::ldexp(1.0, -depth));
      for (int c = 0; c < 3; ++c) {
        EXPECT_LT(std::abs(z_score(picture.whole(c), exactly(exact[c]), 1e-5 * exact[c])), sidak_limit(90))
            << mode.key << " depth " << depth << ": " << picture.whole(c).mean << ", exactly " << exact[c];
      }
    }
  }
}

// A block of lossless glass of side 1 around the origin in an even sky of 100 nits.
Scene glass_in_an_even_sky() {
  Scene open;
  const Quad front{{-0.5, -0.5, 0.5}, {1, 0, 0}, {0, 1, 0}};
  glm::dmat4 side(1.0);
  for (int i = 0; i < 4; ++i) {
    place(open, front, glass(), side);
    side = glm::dmat4({0, 0, -1, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 1}) * side;
  }
  place(open, {{-0.5, 0.5, 0.5}, {1, 0, 0}, {0, 0, -1}}, glass());
  place(open, {{-0.5, -0.5, -0.5}, {1, 0, 0}, {0, 0, 1}}, glass());
  open.environment = Environment{glm::vec3(100.0F), glm::vec3(100.0F), glm::vec3(100.0F)};
  return open;
}

void expect_even(const Scene& scene, Numbers numbers, double nits) {
  const auto baked = bake(scene, numbers);
  for (const Mode& mode : modes()) {
    SCOPED_TRACE(mode.key);
    const TilePicture picture = render_tiles(*baked, mode, {.batch_samples = 8});
    for (int tile = 0; tile < picture.tiles(); ++tile) {
      EXPECT_LT(std::abs(z_score(picture.estimate(tile, 1), exactly(nits), 1e-4 * nits)), sidak_limit(6 * 64))
          << "tile " << tile << ": " << picture.estimate(tile, 1).mean << ", exactly " << nits;
    }
  }
}

// What is refracted, reflected within and refracted again has the sky's radiance: the glass cannot be seen.
TEST_P(Furnace, GlassIsInvisibleInAnEvenSky) {
  Scene scene = glass_in_an_even_sky();
  scene.cameras.push_back(look_at({1.1, 0.9, 1.3}, {0.0, 0.0, 0.0}));
  expect_even(scene, GetParam(), 100.0);
}

// Within glass radiance is larger by the square of the index, since the same light fills a smaller cone.
TEST_P(Furnace, WithinGlassASkyIsBrighter) {
  Scene scene = glass_in_an_even_sky();
  scene.cameras.push_back(look_at({0.0, 0.0, 0.1}, {0.0, 0.0, -0.5}, 0.3));
  expect_even(scene, GetParam(), 100.0 * 1.5 * 1.5);
}

INSTANTIATE_TEST_SUITE_P(Numbers, Furnace, testing::Values(Numbers::kFloat, Numbers::kFixed),
                         [](const auto& test) { return std::string(numbers_name(test.param)); });

}  // namespace
}  // namespace vitrine
