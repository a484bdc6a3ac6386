// A Lambertian plane under lights of every kind shows albedo / pi times the irradiance that is known in
// closed form: in every mode that can find the light, in both number systems, wherever the light is and
// however it was placed.
#include <algorithm>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "integrators/irradiance.h"
#include "scene/environment_lattice.h"
#include "scene/made_scene.h"
#include "statistics/picture.h"

namespace vitrine {
namespace {

const glm::vec3 kAlbedo(0.8F, 0.6F, 0.4F);
const glm::vec3 kColor(1.0F, 0.5F, 0.25F);
// What the arithmetic may add to the statistical error: a hit is off by about 2^-22 of the scene's extent,
// which matters most for a light that nearly touches the plane.
constexpr double kRounding = 3e-4;

/// A plane through the origin that is looked at around the origin from `eye_height` above, and the irradiance
/// there.
struct LitPlane {
  std::string name;
  Scene scene;
  glm::dvec3 irradiance{0.0};
  int samples = 64;  ///< a pixel and batch
};

constexpr double kPatch = 1e-4;  // half of what the camera sees, metres

Scene plane_seen_from(double eye_height) {
  Scene scene;
  place(scene, {{-2, 0, -2}, {0, 0, 4}, {4, 0, 0}}, matte(kAlbedo));
  scene.cameras.push_back(
      close_up({0.3 * eye_height, eye_height, 0.2 * eye_height}, glm::dvec3(0.0), kPatch));
  return scene;
}

constexpr glm::dvec3 kUp(0.0, 1.0, 0.0);

LitPlane under(const std::string& name, const std::vector<PunctualLight>& lights) {
  LitPlane lit{.name = name, .scene = plane_seen_from(1.0)};
  for (const PunctualLight& light : lights) {
    lit.scene.lights.push_back(light);
    lit.irradiance += punctual_irradiance(light, glm::dvec3(0.0), kUp);
  }
  return lit;
}

LitPlane under_quad(const std::string& name, const Quad& quad, bool double_sided = false,
                    double eye_height = 0.004, const glm::dmat4& to_world = glm::dmat4(1.0)) {
  LitPlane lit{.name = name, .scene = plane_seen_from(eye_height), .samples = 256};
  place(lit.scene, quad, lamp(50.0F * kColor, double_sided), to_world);
  std::vector<glm::dvec3> corners = quad.corners();
  for (glm::dvec3& p : corners) p = glm::dvec3(to_world * glm::dvec4(p, 1.0));
  lit.irradiance = 50.0 * glm::dvec3(kColor) * polygon_irradiance(corners, glm::dvec3(0.0), kUp);
  return lit;
}

PunctualLight spot(double inner_rad, double outer_rad) {
  return {.name = "spot",
          .kind = PunctualKind::kSpot,
          .intensity = 100.0F * kColor,
          .position = {0.8, 1.2, 0.0},
          .direction = glm::normalize(glm::dvec3(-0.3, -1.2, 0.1)),
          .inner_cone_rad = inner_rad,
          .outer_cone_rad = outer_rad};
}

/// Brighter on one side, with a sun that gives about as much light as the rest; or the same everywhere.
EnvironmentPicture sun_and_sky(bool even) {
  EnvironmentPicture picture;
  picture.width = 32;
  picture.height = 16;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const float bright = even ? 1.0F : 0.5F + static_cast<float>(x) / 32.0F;
      picture.values.push_back(!even && x == 20 && y == 4 ? glm::vec3(100.0F, 80.0F, 60.0F)
                                                          : bright * kColor);
    }
  }
  return picture;
}

std::vector<LitPlane> lit_planes() {
  const glm::vec3 candela = 100.0F * kColor;
  std::vector<LitPlane> all;
  all.push_back(under("point overhead", {point_light(candela, {0.3, 1.5, -0.2})}));
  all.push_back(under("point grazing", {point_light(candela, {1.0, 0.02, 0.3})}));
  all.push_back(under("point close by", {point_light(candela, {0.01, 0.03, 0.02})}));
  all.push_back(under("point below", {point_light(candela, {0.1, -0.5, 0.1})}));
  all.push_back(under("inside the inner cone", {spot(0.5, 0.6)}));
  all.push_back(under("between the cones", {spot(0.1, 0.6)}));
  all.push_back(under("outside the outer cone", {spot(0.1, 0.2)}));
  const glm::vec3 lux = 1000.0F * kColor;
  all.push_back(under("sun at noon", {sun(lux, {0.3, -1.0, 0.2})}));
  all.push_back(under("sun at dusk", {sun(lux, {1.0, -0.02, 0.1})}));
  all.push_back(under("sun below", {sun(lux, {0.1, 1.0, 0.1})}));
  all.push_back(under("five lights", {sun(lux, {0.3, -1.0, 0.2}), spot(0.1, 0.6), spot(0.1, 0.2),
                                      point_light(candela, {0.3, 1.5, -0.2}),
                                      point_light(0.01F * candela, {0.3, 0.5, -0.2})}));

  const Quad overhead{{-0.4, 1.2, -0.6}, {0.9, 0, 0}, {0, 0, 0.7}};  // faces down
  all.push_back(under_quad("quad overhead", overhead));
  all.push_back(under_quad("quad close by", {{-0.5, 0.02, -0.5}, {1, 0, 0}, {0, 0, 1}}));
  all.push_back(under_quad("quad upright", {{0.5, 0.0, -0.5}, {0, 0, 1}, {0, 0.8, 0}}));
  all.push_back(under_quad("quad on the horizon", {{1.5, 0.0, -0.5}, {0, 0, 1}, {0, 0.05, 0}}));
  all.push_back(under_quad("quad tilted", {{-0.2, 0.5, -0.6}, {0.7, 0.3, 0}, {-0.1, 0.2, 0.7}}));
  const Quad back_turned{overhead.corner, overhead.v, overhead.u};
  all.push_back(under_quad("quad shining up", back_turned));
  all.back().irradiance = glm::dvec3(0.0);
  all.push_back(under_quad("quad shining both ways", back_turned, true));

  // The lamp as an instance: a mesh elsewhere, brought to about the same place.
  const Quad unit{{-0.5, 0, -0.5}, {1, 0, 0}, {0, 0, 1}};  // faces down
  const glm::dmat4 up = glm::translate(glm::dmat4(1.0), glm::dvec3(0.1, 0.9, -0.2));
  const glm::dmat4 turn = glm::rotate(up, 0.5, glm::dvec3(0.6, 0.0, 0.8));
  all.push_back(under_quad("quad turned", unit, false, 0.004, turn));
  all.push_back(
      under_quad("quad stretched", unit, false, 0.004, glm::scale(turn, glm::dvec3(1.7, 1.0, 0.3))));
  all.push_back(
      under_quad("quad mirrored", unit, false, 0.004, glm::scale(turn, glm::dvec3(-1.0, 1.0, 0.6))));
  all.push_back(under_quad(
      "quad turned inside out", back_turned, false, 0.004,
      glm::translate(glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, -1.0, 1.0)), glm::dvec3(0.0, -2.4, 0.0))));

  for (const bool even : {false, true}) {
    LitPlane pictured{.name = even ? "even picture" : "picture of sun and sky",
                      .scene = plane_seen_from(1.0)};
    const EnvironmentPicture picture = sun_and_sky(even);
    pictured.scene.environment_picture = picture;
    pictured.irradiance = lattice_irradiance(make_environment_lattice(picture));
    pictured.samples = 256;
    all.push_back(pictured);
  }

  const Environment sky{{600.0F, 750.0F, 1000.0F}, {1000.0F, 900.0F, 500.0F}, {350.0F, 330.0F, 300.0F}};
  LitPlane outside{.name = "sky", .scene = plane_seen_from(1.0), .irradiance = sky_irradiance(sky)};
  outside.scene.environment = sky;
  all.push_back(outside);
  LitPlane mixed = under_quad("quad, sun and black sky", {{0.3, 0.0, -0.5}, {0, 0, 1}, {0, 0.8, 0}});
  const PunctualLight noon = sun(lux, {0.0, -1.0, 0.0});
  mixed.scene.lights.push_back(noon);
  mixed.scene.environment = Environment{};
  mixed.irradiance += punctual_irradiance(noon, glm::dvec3(0.0), kUp);
  all.push_back(mixed);
  return all;
}

class LitPlanes : public testing::TestWithParam<LitPlane> {};

TEST_P(LitPlanes, MatchesTheClosedForm) {
  const LitPlane& lit = GetParam();
  constexpr std::size_t kTests = 26 * 2 * 3 * 3;
  int modes_tried = 0;
  for (const Numbers numbers : {Numbers::kFloat, Numbers::kFixed}) {
    const auto scene = bake(lit.scene, numbers);
    for (const Mode& mode : modes()) {
      if (!can_render(mode, lit.scene)) continue;
      ++modes_tried;
      const TilePicture picture = render_tiles(*scene, mode,
                                               {.size = 4,
                                                .tile = 4,
                                                .batches = 32,
                                                .batch_samples = static_cast<std::uint32_t>(lit.samples),
                                                .max_depth = 1});
      for (int c = 0; c < 3; ++c) {
        const double exact = static_cast<double>(kAlbedo[c]) / std::numbers::pi * lit.irradiance[c];
        const Estimate shown = picture.whole(c);
        EXPECT_LT(std::abs(z_score(shown, exactly(exact), kRounding * exact)), sidak_limit(kTests))
            << numbers_name(numbers) << ' ' << mode.key << " channel " << c << ": " << shown.mean << " +- "
            << std::sqrt(shown.variance) << ", exactly " << exact;
      }
    }
  }
  EXPECT_GE(modes_tried, 4);
}

INSTANTIATE_TEST_SUITE_P(DirectLight, LitPlanes, testing::ValuesIn(lit_planes()), [](const auto& test) {
  std::string name = test.param.name;
  std::ranges::replace_if(
      name, [](char c) { return c == ',' || c == ' '; }, '_');
  return name;
});

// The whole is turned, stretched and mirrored: as long as plane, lamp and camera keep their places in the
// world, it does not matter by which transform each came there.
TEST(DirectLightOnInstances, PlaneMayBeTurnedAndStretched) {
  const Quad quad{{-0.4, 1.2, -0.6}, {0.9, 0, 0}, {0, 0, 0.7}};
  const Quad upright{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
  const glm::dmat4 laid = glm::rotate(glm::dmat4(1.0), -std::numbers::pi / 2, glm::dvec3(1, 0, 0));
  for (const glm::dvec3& stretch : {glm::dvec3(2, 2, 1), glm::dvec3(3, 1.5, 0.1), glm::dvec3(-2, 2, 1)}) {
    const glm::dvec3 irradiance =
        50.0 * glm::dvec3(kColor) * polygon_irradiance(quad.corners(), glm::dvec3(0.0), kUp);
    for (const Numbers numbers : {Numbers::kFloat, Numbers::kFixed}) {
      Scene scene;
      place(scene, upright, matte(kAlbedo), glm::scale(laid, stretch));
      place(scene, quad, lamp(50.0F * kColor));
      scene.cameras.push_back(close_up({0.1, 0.5, 0.1}, glm::dvec3(0.0), kPatch));
      const auto baked = bake(scene, numbers);
      const TilePicture picture = render_tiles(*baked, *find_mode("mis"), {.size = 4, .max_depth = 1});
      for (int c = 0; c < 3; ++c) {
        const double exact = static_cast<double>(kAlbedo[c]) / std::numbers::pi * irradiance[c];
        EXPECT_LT(std::abs(z_score(picture.whole(c), exactly(exact), kRounding * exact)), sidak_limit(18));
      }
    }
  }
}

// A perspective picture of the plane, tile by tile: what is up, what is left, and how wide the view is.
TEST(DirectLightInPerspective, EveryTileMatchesTheClosedForm) {
  Scene scene;
  place(scene, {{-2, 0, -2}, {0, 0, 4}, {4, 0, 0}}, matte(kAlbedo));
  const PunctualLight light = point_light(100.0F * kColor, {0.4, 0.5, -0.3});
  scene.lights.push_back(light);
  const glm::dvec3 eye(0.5, 1.6, 1.3);
  const double yfov_rad = 0.7;
  scene.cameras.push_back(look_at(eye, glm::dvec3(0.0), yfov_rad));
  const glm::dmat3 axes(scene.cameras.front().to_world);
  constexpr int kSize = 16;
  constexpr int kTile = 4;
  const auto exact = [&](double x, double y, int c) {  // in pixels, y down
    const double half = std::tan(yfov_rad / 2);
    const glm::dvec3 d = axes * glm::dvec3((2 * x / kSize - 1) * half, (1 - 2 * y / kSize) * half, -1.0);
    const glm::dvec3 p = eye - d * (eye.y / d.y);
    return static_cast<double>(kAlbedo[c]) / std::numbers::pi * punctual_irradiance(light, p, kUp)[c];
  };
  for (const Numbers numbers : {Numbers::kFloat, Numbers::kFixed}) {
    const auto baked = bake(scene, numbers);
    for (const Mode& mode : modes()) {
      if (!can_render(mode, scene)) continue;
      const TilePicture picture = render_tiles(*baked, mode, {.size = kSize, .tile = kTile, .max_depth = 1});
      for (int tile = 0; tile < picture.tiles(); ++tile) {
        const int x0 = tile % (kSize / kTile) * kTile;
        const int y0 = tile / (kSize / kTile) * kTile;
        constexpr int kSteps = 32;
        for (int c = 0; c < 3; ++c) {
          double mean = 0.0;
          for (int i = 0; i < kSteps * kSteps; ++i) {
            mean +=
                exact(x0 + (i % kSteps + 0.5) * kTile / kSteps, y0 + (i / kSteps + 0.5) * kTile / kSteps, c) /
                (kSteps * kSteps);
          }
          EXPECT_LT(std::abs(z_score(picture.estimate(tile, c), exactly(mean), kRounding * mean)),
                    sidak_limit(192))
              << numbers_name(numbers) << ' ' << mode.key << " tile " << tile;
        }
      }
    }
  }
}

}  // namespace
}  // namespace vitrine
