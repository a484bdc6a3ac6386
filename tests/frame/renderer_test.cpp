#include "frame/renderer.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "integrators/film_hash.h"
#include "scene/made_scene.h"
#include "statistics/picture.h"

namespace vitrine {
namespace {

Scene lit_room(float scale) {
  Scene scene;
  place_room(scene, 1.0, matte({0.7F, 0.5F, 0.3F}));
  place(scene, {{-0.3, 0.9, -0.3}, {0.6, 0, 0}, {0, 0, 0.6}}, lamp(glm::vec3(1.0F, 0.9F, 0.7F) * scale));
  scene.cameras.push_back(look_at({0.6, 0.1, 0.8}, {-0.2, -0.3, -0.4}));
  return scene;
}

class RendererIn : public testing::TestWithParam<Numbers> {
 protected:
  static constexpr int kSize = 16;
  static constexpr Tile kAll{0, 0, kSize, kSize};

  struct Shot {
    Film film;
    Exposure exposure;
    std::vector<std::uint8_t> rgb;
  };
  static Shot shoot(const Scene& scene, const char* mode = "mis", std::uint32_t samples = 16) {
    const auto baked = bake(scene, GetParam());
    const auto renderer =
        baked->make_renderer({.mode = find_mode(mode), .width = kSize, .height = kSize, .seed = 1});
    Shot shot{
        .film = renderer->make_film(), .exposure = {}, .rgb = std::vector<std::uint8_t>(3U * kSize * kSize)};
    const std::atomic<bool> cancel{false};
    renderer->trace(kAll, {0, samples}, shot.film, cancel);
    shot.exposure = renderer->meter(shot.film);
    renderer->develop(shot.film, kAll, shot.exposure, shot.rgb.data());
    return shot;
  }
};

// From starlight to the sun's disc: the film's exponent takes it all, so a power of two changes nothing else.
TEST_P(RendererIn, ShowsTheSamePictureInAnyLight) {
  const Shot shot = shoot(lit_room(1.0F));
  for (const int k : {-20, 1, 30}) {
    const Shot scaled = shoot(lit_room(std::ldexp(1.0F, k)));
    EXPECT_EQ(film_hash(scaled.film), film_hash(shot.film)) << k;
    EXPECT_EQ(scaled.film.exponent(), shot.film.exponent() + k);
    EXPECT_EQ(scaled.exposure.quarter_stops, shot.exposure.quarter_stops - 4 * k);
    EXPECT_EQ(scaled.rgb, shot.rgb) << k;
  }
}

TEST_P(RendererIn, MeasuresSunlightAndStarlight) {
  const Shot shot = shoot(lit_room(1.0F));
  for (const float nits : {1e9F, 1e-6F}) {
    const Shot scaled = shoot(lit_room(nits));
    for (int i = 0; i < kSize * kSize; ++i) {
      const glm::dvec3 expected = shot.film.mean_nits(i % kSize, i / kSize) * static_cast<double>(nits);
      const glm::dvec3 found = scaled.film.mean_nits(i % kSize, i / kSize);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-4 * expected[c]) << nits;
    }
  }
}

TEST_P(RendererIn, MayBeTracedAndDevelopedInTiles) {
  const auto scene = bake(lit_room(1.0F), GetParam());
  const auto renderer =
      scene->make_renderer({.mode = find_mode("mis"), .width = kSize, .height = kSize, .seed = 1});
  Film film = renderer->make_film();
  const std::atomic<bool> cancel{false};
  renderer->trace(kAll, {0, 4}, film, cancel);
  std::vector<std::uint8_t> whole(3U * kSize * kSize);
  renderer->develop(film, kAll, {2}, whole.data());
  std::vector<std::uint8_t> tiled(whole.size());
  for (const Tile& tile : {Tile{0, 0, 5, kSize}, Tile{5, 0, kSize, 7}, Tile{5, 7, kSize, kSize}}) {
    renderer->develop(film, tile, {2}, tiled.data());
  }
  EXPECT_EQ(tiled, whole);
}

TEST_P(RendererIn, ShowsAPictureOfMiddlingBrightness) {
  const Shot shot = shoot(lit_room(1.0F), "mis", 64);
  double sum = 0.0;
  for (const std::uint8_t code : shot.rgb) sum += code;
  const double mean = sum / static_cast<double>(shot.rgb.size());
  EXPECT_GT(mean, 60.0);
  EXPECT_LT(mean, 190.0);
}

TEST_P(RendererIn, CountsTrianglesAndLights) {
  const auto scene = bake(lit_room(1.0F), GetParam());
  EXPECT_EQ(scene->triangle_count(), 14U);
  EXPECT_EQ(scene->light_count(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Numbers, RendererIn, testing::Values(Numbers::kFloat, Numbers::kFixed),
                         [](const auto& test) { return std::string(numbers_name(test.param)); });

TEST(NumbersNames, AreReadBack) {
  for (const Numbers numbers : {Numbers::kFloat, Numbers::kFixed}) {
    EXPECT_EQ(numbers_from_name(numbers_name(numbers)), numbers);
  }
  EXPECT_EQ(numbers_from_name("double"), std::nullopt);
}

TEST(Modes, AreFoundByTheirKeys) {
  for (const Mode& mode : modes()) EXPECT_EQ(find_mode(mode.key), &mode);
  EXPECT_EQ(find_mode("no such mode"), nullptr);
}

}  // namespace
}  // namespace vitrine
