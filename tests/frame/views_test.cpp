#include "frame/views.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "frame/variance_map.h"
#include "scene/made_scene.h"

namespace vitrine {
namespace {

using Colour = std::array<std::uint8_t, 3>;

/// A pixel of mean 1 with this relative standard error.
Film::Pixel pixel_of_error(double error) {
  Film film(1, 1, 0);
  for (const double value : {1.0 - error, 1.0 + error})
    film.add(0, 0, FilmValue(static_cast<std::int64_t>(std::ldexp(value, kFilmBits))));
  return film.at(0, 0);
}

int brightness(const Colour& colour) { return 2126 * colour[0] + 7152 * colour[1] + 722 * colour[2]; }

TEST(Views, AreFoundByTheirKeys) {
  std::set<std::string_view> keys;
  for (const View& view : views()) {
    EXPECT_EQ(find_view(view.key), &view);
    keys.insert(view.key);
  }
  EXPECT_EQ(keys.size(), views().size());
  EXPECT_EQ(views().front().key, "picture");
  EXPECT_TRUE(views().front().label.empty());
  EXPECT_EQ(find_view("no such view"), nullptr);
}

TEST(VarianceMap, GoesFromBlackToWhite) {
  for (const std::uint8_t part : variance_colour(pixel_of_error(1.0))) EXPECT_GE(part, 250);
  EXPECT_EQ(variance_colour(pixel_of_error(0.003)), (Colour{0, 0, 0}));
  EXPECT_EQ(variance_colour(pixel_of_error(0.0)), (Colour{0, 0, 0}));
  int before = -1;
  int steps = 0;
  for (double error = 0.004; error < 0.99; error *= 1.05) {
    const int now = brightness(variance_colour(pixel_of_error(error)));
    EXPECT_GE(now, before) << error;
    steps += now > before ? 1 : 0;
    before = now;
  }
  EXPECT_GT(steps, 100) << "as many colours as there are errors to tell apart";
}

// What the legend says.
TEST(VarianceMap, IsRedAtTenPercent) {
  const Colour colour = variance_colour(pixel_of_error(0.1));
  EXPECT_GT(colour[0], 150);
  EXPECT_LT(colour[1], colour[0] / 2);
  EXPECT_LT(colour[2], colour[0] / 2);
}

TEST(VarianceMap, IsGreyWhereNothingIsKnown) {
  Film film(2, 1, 0);
  film.add(0, 0, FilmValue(1000));
  for (int i = 0; i < 9; ++i) film.add(1, 0, FilmValue(0));
  for (const int x : {0, 1}) {
    const Colour colour = variance_colour(film.at(x, 0));
    EXPECT_EQ(colour[0], colour[1]);
    EXPECT_EQ(colour[1], colour[2]);
    EXPECT_GT(colour[0], 0);
    EXPECT_LT(colour[0], 255);
  }
}

TEST(VarianceMap, MayBeDevelopedInTiles) {
  Scene scene;
  place_room(scene, 1.0, matte({0.7F, 0.5F, 0.3F}));
  place(scene, {{-0.3, 0.9, -0.3}, {0.6, 0, 0}, {0, 0, 0.6}}, lamp(glm::vec3(1.0F)));
  scene.cameras.push_back(look_at({0.6, 0.1, 0.8}, {-0.2, -0.3, -0.4}));
  const auto baked = bake(scene, Numbers::kFixed);
  RenderOptions options;
  options.mode = find_mode("nee");
  options.width = 20;
  options.height = 12;
  const auto renderer = baked->make_renderer(options);
  Film film = renderer->make_film();
  const std::atomic<bool> cancel{false};
  renderer->trace({0, 0, 20, 12}, {0, 8}, film, cancel);

  for (const View& view : views()) {
    std::vector<std::uint8_t> whole(std::size_t{20} * 12 * 3);
    view.develop(*renderer, film, {0, 0, 20, 12}, {}, whole.data());
    std::vector<std::uint8_t> tiled(whole.size());
    view.develop(*renderer, film, {0, 0, 7, 12}, {}, tiled.data());
    view.develop(*renderer, film, {7, 0, 20, 12}, {}, tiled.data());
    EXPECT_EQ(whole, tiled) << view.key;
    EXPECT_GT(std::set(whole.begin(), whole.end()).size(), 10U) << view.key;
  }
}

}  // namespace
}  // namespace vitrine
