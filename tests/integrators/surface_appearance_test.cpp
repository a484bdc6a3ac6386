// What a surface is beyond its BSDF, in pictures whose values are known: coverage (alpha mask and blend),
// normal maps, absorption inside of solids. In both number systems, by light that is met by chance, by shadow
// rays and by both.
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "integrators/film_hash.h"
#include "integrators/irradiance.h"
#include "scene/made_scene.h"
#include "statistics/picture.h"

namespace vitrine {
namespace {

const glm::vec3 kAlbedo(0.8F, 0.6F, 0.4F);
const glm::vec3 kColor(1.0F, 0.5F, 0.25F);
constexpr glm::dvec3 kUp(0.0, 1.0, 0.0);
constexpr double kRounding = 3e-4;  // of a picture's value, what the arithmetic may add
constexpr std::size_t kTests = 200;

/// Holds the picture of the scene's first camera against one value that all of it has.
void expect_shows(const Scene& scene, const glm::dvec3& nits, int max_depth = 1) {
  for (const Numbers numbers : {Numbers::kFloat, Numbers::kFixed}) {
    const auto baked = bake(scene, numbers);
    for (const char* key : {"basic-brdf-cosine", "nee", "mis"}) {
      const Mode& mode = *find_mode(key);
      if (!can_render(mode, scene)) continue;
      const TilePicture picture = render_tiles(
          *baked, mode, {.size = 4, .tile = 4, .batches = 32, .batch_samples = 128, .max_depth = max_depth});
      for (int c = 0; c < 3; ++c) {
        const Estimate shown = picture.whole(c);
        EXPECT_LT(std::abs(z_score(shown, exactly(nits[c]), kRounding * nits[c])), sidak_limit(kTests))
            << numbers_name(numbers) << ' ' << key << " channel " << c << ": " << shown.mean << " +- "
            << std::sqrt(shown.variance) << ", exactly " << nits[c];
      }
    }
  }
}

/// A square of half a side `half` at height y, front up (or down).
Quad level(double y, double half, bool down = false) {
  const glm::dvec3 x(2 * half, 0, 0);
  const glm::dvec3 z(0, 0, 2 * half);
  return {{-half, y, -half}, down ? x : z, down ? z : x};
}

Material covering(Material material, float alpha) {
  material.alpha_mode = AlphaMode::kBlend;
  material.alpha = alpha;
  return material;
}
const Material kBlack = matte(glm::vec3(0.0F));

/// A matte floor that is looked at around the origin from close above, so that nothing else comes between.
Scene floor_seen_from_close() {
  Scene scene;
  place(scene, level(0, 2), matte(kAlbedo));
  scene.cameras.push_back(close_up({0.012, 0.04, 0.008}, glm::dvec3(0.0), 1e-3));
  return scene;
}
glm::dvec3 floor_radiance(const glm::dvec3& irradiance) {
  return glm::dvec3(kAlbedo) / std::numbers::pi * irradiance;
}

TEST(Coverage, ABlendedLampShowsItselfAndWhatIsBehind) {
  Scene scene;
  place(scene, level(1, 1), covering(lamp(8.0F * kColor), 0.3F));
  place(scene, level(0, 1), lamp(glm::vec3(1.0F, 2.0F, 4.0F)));
  scene.cameras.push_back(look_at({0.2, 3, 0.1}, {0, 0, 0}, 0.3));
  expect_shows(scene, 0.3 * 8.0 * glm::dvec3(kColor) + 0.7 * glm::dvec3(1, 2, 4));
}

TEST(Coverage, AStackOfSheetsLetsThroughThePowerOfOneToCameraRays) {
  Scene scene;
  for (const double y : {1.0, 0.9, 0.8, 0.3}) place(scene, level(y, 1), covering(kBlack, 0.25F));
  place(scene, level(0, 1), lamp(kColor));
  scene.cameras.push_back(look_at({0.2, 3, 0.1}, {0, 0, 0}, 0.3));
  expect_shows(scene, std::pow(0.75, 4) * glm::dvec3(kColor));
}

TEST(Coverage, AndToShadowRays) {
  Scene scene = floor_seen_from_close();
  for (const double y : {0.5, 0.6, 0.7}) place(scene, level(y, 1.5), covering(kBlack, 0.25F));
  const Quad quad{{-0.4, 1.2, -0.6}, {0.9, 0, 0}, {0, 0, 0.7}};
  place(scene, quad, lamp(50.0F * kColor));
  const glm::dvec3 of_quad =
      50.0 * glm::dvec3(kColor) * polygon_irradiance(quad.corners(), glm::dvec3(0.0), kUp);
  expect_shows(scene, floor_radiance(std::pow(0.75, 3) * of_quad));
  const PunctualLight point = point_light(100.0F * kColor, {0.9, 1.5, 0.6});
  scene.lights.push_back(point);
  expect_shows(scene, floor_radiance(std::pow(0.75, 3) *
                                     (of_quad + punctual_irradiance(point, glm::dvec3(0.0), kUp))));
}

// A lamp of coverage a sends out a of its light, and lets 1 - a of another's through, that it hides.
TEST(Coverage, ABlendedLampShinesByItsCoverage) {
  Scene scene = floor_seen_from_close();
  const Quad near_by = level(1.0, 0.6, true);
  const Quad behind = level(1.2, 0.3, true);
  place(scene, near_by, covering(lamp(20.0F * kColor), 0.4F));
  place(scene, behind, lamp(glm::vec3(50.0F, 100.0F, 150.0F)));
  const glm::dvec3 origin(0.0);
  expect_shows(
      scene,
      floor_radiance(0.4 * 20.0 * glm::dvec3(kColor) * polygon_irradiance(near_by.corners(), origin, kUp) +
                     0.6 * glm::dvec3(50, 100, 150) * polygon_irradiance(behind.corners(), origin, kUp)));
}

/// Two texels in a row: clear, then full.
Image half_clear() { return {2, 1, {0, 0, 0, 0, 0, 0, 0, 255}}; }
Material masked(Material material) {
  material.alpha_mode = AlphaMode::kMask;
  material.alpha_texture.image = 0;
  material.alpha_texture.nearest = true;
  return material;
}
/// Texture coordinates of a quad, u along its edge u from `first` to `last`.
void set_u(Scene& scene, float first, float last) {
  scene.meshes.back().primitives.front().uv[0] = {{first, 0}, {last, 0}, {last, 1}, {first, 1}};
}

TEST(Coverage, AMaskedLampShinesWhereItIs) {
  Scene scene = floor_seen_from_close();
  scene.images.push_back(half_clear());
  place(scene, {{-0.5, 0.8, -0.4}, {1.0, 0, 0}, {0, 0, 0.7}}, masked(lamp(30.0F * kColor)));
  set_u(scene, 0, 1);
  const Quad right{{0.0, 0.8, -0.4}, {0.5, 0, 0}, {0, 0, 0.7}};
  expect_shows(scene, floor_radiance(30.0 * glm::dvec3(kColor) *
                                     polygon_irradiance(right.corners(), glm::dvec3(0.0), kUp)));
}

std::uint64_t picture_hash(const BakedScene& scene, Driver driver, int wave_size) {
  const auto renderer = scene.make_renderer({.mode = find_mode("mis"),
                                             .width = 24,
                                             .height = 24,
                                             .seed = 5,
                                             .driver = driver,
                                             .wave_size = wave_size});
  Film film = renderer->make_film();
  const std::atomic<bool> cancel{false};
  renderer->trace({0, 0, 24, 24}, {0, 4}, film, cancel);
  return film_hash(film);
}

/// A card of two halves over a lit floor. The left half is masked away, or was never there.
Scene card_over_floor(bool mask) {
  Scene scene = floor_seen_from_close();
  scene.cameras.front() = look_at({0, 1.5, 2}, {0, 0.2, 0});
  scene.images.push_back(half_clear());
  place(scene, level(1.5, 0.2, true), lamp(50.0F * kColor));
  const Material card = matte(glm::vec3(0.3F));
  place(scene, {{0, 0.5, 0.4}, {0.5, 0, 0}, {0, 0, -0.8}}, mask ? masked(card) : card);
  set_u(scene, 0.5F, 1);
  if (mask) {
    place(scene, {{-0.5, 0.5, 0.4}, {0.5, 0, 0}, {0, 0, -0.8}}, masked(card));
    set_u(scene, 0, 0.5F);
  }
  return scene;
}

TEST(Coverage, AMaskIsExactlyTheGeometryThatItLeaves) {
  for (const Numbers numbers : {Numbers::kFloat, Numbers::kFixed}) {
    const auto cut = picture_hash(*bake(card_over_floor(false), numbers), Driver::kWave, 4096);
    EXPECT_EQ(picture_hash(*bake(card_over_floor(true), numbers), Driver::kWave, 4096), cut);
    Scene whole = card_over_floor(true);
    whole.images.front().rgba[3] = 255;
    EXPECT_NE(picture_hash(*bake(whole, numbers), Driver::kWave, 4096), cut);
  }
}

TEST(Coverage, IsTheSameForEitherDriverAndAnyWave) {
  Scene scene = card_over_floor(false);
  scene.materials.back() = covering(scene.materials.back(), 0.5F);
  for (const Numbers numbers : {Numbers::kFloat, Numbers::kFixed}) {
    const auto baked = bake(scene, numbers);
    const auto hash = picture_hash(*baked, Driver::kWave, 4096);
    EXPECT_EQ(picture_hash(*baked, Driver::kWave, 37), hash);
    EXPECT_EQ(picture_hash(*baked, Driver::kPath, 1), hash);
  }
}

// A texel that leans by 40 degrees: the floor is as bright as one that is turned.
TEST(NormalMap, ShadesAsATiltedPlane) {
  Scene scene = floor_seen_from_close();
  scene.images.push_back({1, 1, {209, 128, 225, 255}});
  const glm::dvec3 texel(209 / 127.5 - 1, 128 / 127.5 - 1, 225 / 127.5 - 1);
  // The floor's u runs along +z, its v along +x: bitangents, against v, along -x.
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-texel.y, texel.z, texel.x));
  scene.materials.back().normal_texture.image = 0;
  scene.meshes.back().primitives.front().uv[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Scene lamps = scene;
  const Quad quad{{-0.2, 0.9, 0.2}, {0.5, 0, 0}, {0, 0, 0.7}};
  place(lamps, quad, lamp(50.0F * kColor));
  expect_shows(lamps, floor_radiance(50.0 * glm::dvec3(kColor) *
                                     polygon_irradiance(quad.corners(), glm::dvec3(0.0), normal)));
  for (const glm::dvec3& direction : {glm::dvec3(0.1, -1, -0.8), glm::dvec3(0.3, -1, 0.2)}) {
    Scene sunny = scene;
    sunny.lights.push_back(sun(1000.0F * kColor, direction));
    expect_shows(sunny, floor_radiance(punctual_irradiance(sunny.lights.front(), glm::dvec3(0.0), normal)));
  }
}

const glm::vec3 kGreen(0.5F, 0.9F, 0.25F);

glm::dvec3 left_after(double metres, double attenuation_distance) {
  return glm::pow(glm::dvec3(kGreen), glm::dvec3(metres / attenuation_distance));
}

// Both boundaries at normal incidence, with all reflections between them: (1 - R)^2 t / (1 - R^2 t^2).
TEST(Absorption, OfASlabOfGlass) {
  constexpr double kThickness = 0.7;
  Material green = glass();
  green.ior = 2.0F;
  green.attenuation_color = kGreen;
  green.attenuation_distance = 0.4F;
  Scene scene;
  place(scene, level(0, 1), green);
  place(scene, level(-kThickness, 1, true), green);
  place(scene, level(-1, 1), lamp(kColor));
  scene.cameras.push_back(close_up({0, 1, 0}, {0, 0, 0}, 0.1));
  const double r = 1.0 / 9.0;
  glm::dvec3 through(0.0);
  for (int c = 0; c < 3; ++c) {
    const double t = left_after(kThickness, 0.4)[c];
    through[c] = (1 - r) * (1 - r) * t / (1 - r * r * t * t);
  }
  expect_shows(scene, through * glm::dvec3(kColor), 12);
}

/// A box [-1, 1]^3 of a green solid that bends no light, and in it a floor at the origin.
Scene floor_in_a_solid() {
  Material green = glass();
  green.ior = 1.0F;
  green.specular = 0.0F;
  green.attenuation_color = kGreen;
  green.attenuation_distance = 0.8F;
  Scene scene;
  place_room(scene, 1.0, green);
  for (Primitive& side : scene.meshes.back().primitives) {  // turned outwards
    for (glm::uvec3& triangle : side.triangles) std::swap(triangle.y, triangle.z);
    for (glm::vec3& normal : side.normals) normal = -normal;
  }
  place(scene, level(0, 0.9), matte(kAlbedo));
  scene.cameras.push_back(close_up({0, 2, 0}, {0, 0, 0}, 1e-3));
  return scene;
}

TEST(Absorption, OnTheWayToTheLightAndToTheCamera) {
  const Quad quad{{0.1, 0.4, -0.4}, {0.6, 0, 0}, {0, 0, 0.8}};
  constexpr int kSteps = 200;
  glm::dvec3 irradiance(0.0);
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const glm::dvec3 p = quad.corner + quad.u * ((i + 0.5) / kSteps) + quad.v * ((j + 0.5) / kSteps);
      const double d2 = glm::dot(p, p);
      const double area = 0.6 * 0.8 / (kSteps * kSteps);
      irradiance += left_after(std::sqrt(d2), 0.8) * (p.y * p.y / (d2 * d2) * area);
    }
  }
  Scene scene = floor_in_a_solid();
  place(scene, quad, lamp(50.0F * kColor));
  expect_shows(scene, left_after(1.0, 0.8) * floor_radiance(50.0 * glm::dvec3(kColor) * irradiance), 2);

  Scene pointed = floor_in_a_solid();
  const PunctualLight point = point_light(100.0F * kColor, {0.3, 0.6, -0.2});
  pointed.lights.push_back(point);
  expect_shows(pointed,
               left_after(1.0, 0.8) * left_after(0.7, 0.8) *
                   floor_radiance(punctual_irradiance(point, glm::dvec3(0.0), kUp)),
               2);
}

// The back of a solid is met from inside only: so is a camera's ray that began there.
TEST(Absorption, WhereTheCameraIsInside) {
  Scene scene = floor_in_a_solid();
  scene.materials.back() = kBlack;
  place(scene, level(2, 3, true), lamp(kColor));
  scene.cameras.front() = close_up({0, 0.25, 0}, {0, 1, 0}, 1e-3);
  expect_shows(scene, left_after(0.75, 0.8) * glm::dvec3(kColor));
}

}  // namespace
}  // namespace vitrine
