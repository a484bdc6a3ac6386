// Materials in a number system: what of a surface is there, which way a normal map turns, how much light a
// solid absorbs.
#include "scene/material_baker.h"

#include <cmath>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "number_systems.h"
#include "scene/bake.h"
#include "scene/made_scene.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

Image image_of(std::vector<std::uint8_t> rgba) {
  return {static_cast<int>(rgba.size() / 4), 1, std::move(rgba)};
}

Material with_alpha(AlphaMode mode, float alpha, int image = -1) {
  Material material = matte(glm::vec3(0.5F));
  material.alpha_mode = mode;
  material.alpha = alpha;
  material.alpha_texture.image = image;
  material.alpha_texture.nearest = true;
  return material;
}

template <class N>
class MaterialBakerTest : public testing::Test {
 protected:
  using Unit = typename N::Unit;
  using Length = typename N::Length;

  static bool complete(const Material& material, const std::vector<Image>& images = {}) {
    return MaterialBaker<N>(images, 1.0, 0).bake(material).coverage.complete;
  }
  /// A world of a unit square with texture coordinates, of one material and one image.
  static Scene square_of(const Material& material, Image image = image_of({255, 255, 255, 255})) {
    Scene scene;
    place(scene, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, material);
    scene.meshes.front().primitives.front().uv[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    scene.images.push_back(std::move(image));
    scene.cameras.push_back(look_at({0.5, 0.5, 2}, {0.5, 0.5, 0}));
    return scene;
  }
  /// Where on the square: triangle 0 is below its diagonal from (0, 0) to (1, 1).
  static Hit<N> below_diagonal(double x, double y) {
    return {Length(1), from_host<Unit>(x - y), from_host<Unit>(y), 0};
  }
  static double coverage(const World<N>& world, double x, double y) {
    const Hit<N> hit = below_diagonal(x, y);
    return to_host(world.coverage(hit.triangle, hit.u, hit.v));
  }
};
TYPED_TEST_SUITE(MaterialBakerTest, NumberSystems, NumberSystemNames);

// Where it covers all anyway, traversal must not pay for asking.
TYPED_TEST(MaterialBakerTest, KnowsWhatCoversEverything) {
  const std::vector<Image> images{image_of({0, 0, 0, 255, 9, 9, 9, 255}),
                                  image_of({0, 0, 0, 255, 9, 9, 9, 128})};
  EXPECT_TRUE(this->complete(with_alpha(AlphaMode::kOpaque, 0.2F)));
  EXPECT_TRUE(this->complete(with_alpha(AlphaMode::kBlend, 1.0F)));
  EXPECT_TRUE(this->complete(with_alpha(AlphaMode::kBlend, 1.0F, 0), images));
  EXPECT_FALSE(this->complete(with_alpha(AlphaMode::kBlend, 0.99F)));
  EXPECT_FALSE(this->complete(with_alpha(AlphaMode::kBlend, 1.0F, 1), images));
  EXPECT_TRUE(this->complete(with_alpha(AlphaMode::kMask, 0.5F)));
  EXPECT_FALSE(this->complete(with_alpha(AlphaMode::kMask, 0.499F)));
  EXPECT_TRUE(this->complete(with_alpha(AlphaMode::kMask, 1.0F, 1), images));
  Material nothing = with_alpha(AlphaMode::kMask, 1.0F);
  nothing.alpha_cutoff = 1.5F;
  EXPECT_FALSE(this->complete(nothing));

  EXPECT_FALSE(bake_world<TypeParam>(this->square_of(with_alpha(AlphaMode::kOpaque, 0.2F))).see_through);
  EXPECT_TRUE(bake_world<TypeParam>(this->square_of(with_alpha(AlphaMode::kBlend, 0.2F))).see_through);
}

TYPED_TEST(MaterialBakerTest, CoverageIsFactorTimesTextureTimesVertices) {
  Scene scene =
      this->square_of(with_alpha(AlphaMode::kBlend, 0.5F, 0), image_of({0, 0, 0, 51, 0, 0, 0, 255}));
  const auto plain = bake_world<TypeParam>(scene);
  EXPECT_NEAR(this->coverage(plain, 0.25, 0.125), 0.1, 1e-6);
  EXPECT_NEAR(this->coverage(plain, 0.75, 0.125), 0.5, 1e-6);
  scene.meshes.front().primitives.front().alphas = {1.0F, 0.0F, 0.5F, 1.0F};
  const auto tinted = bake_world<TypeParam>(scene);
  EXPECT_NEAR(this->coverage(tinted, 0.75, 0.125), 0.5 * (1 - 0.625 - 0.5 * 0.125), 1e-6);

  scene.materials.front() = with_alpha(AlphaMode::kBlend, 1.0F);
  EXPECT_TRUE(bake_world<TypeParam>(scene).see_through) << "by its vertices alone";
  scene.materials.front() = with_alpha(AlphaMode::kOpaque, 1.0F);
  EXPECT_FALSE(bake_world<TypeParam>(scene).see_through) << "an opaque surface has no alpha";
}

TYPED_TEST(MaterialBakerTest, AMaskIsThereFromTheCutoffOn) {
  const auto masked = [&](std::uint8_t left, std::uint8_t right, float cutoff) {
    Material material = with_alpha(AlphaMode::kMask, 1.0F, 0);
    material.alpha_cutoff = cutoff;
    return bake_world<TypeParam>(this->square_of(material, image_of({0, 0, 0, left, 0, 0, 0, right})));
  };
  const auto world = masked(127, 128, 0.5F);
  EXPECT_EQ(this->coverage(world, 0.25, 0.125), 0.0);
  EXPECT_EQ(this->coverage(world, 0.75, 0.125), 1.0);
  const auto exactly = masked(50, 51, 0.2F);
  EXPECT_EQ(this->coverage(exactly, 0.25, 0.125), 0.0);
  EXPECT_EQ(this->coverage(masked(255, 0, 1.0F), 0.25, 0.125), 1.0);
  EXPECT_EQ(this->coverage(masked(255, 255, 1.01F), 0.25, 0.125), 0.0);
}

// Of upright texture coordinates, x is to the right, y up; a negative scale turns both.
TYPED_TEST(MaterialBakerTest, ANormalMapTurnsTheNormalInTheFrameOfItsTangents) {
  const Image leaning = image_of({230, 77, 204, 255});
  const glm::dvec3 texel(230 / 127.5 - 1, 77 / 127.5 - 1, 204 / 127.5 - 1);
  for (const float scale : {1.0F, 0.25F, -1.0F, 10.0F}) {
    Material material = matte(glm::vec3(0.5F));
    material.normal_texture.image = 0;
    material.normal_scale = scale;
    const auto factor = static_cast<double>(scale);
    const glm::dvec3 expected = glm::normalize(texel * glm::dvec3(factor, factor, 1.0));
    Scene scene = this->square_of(material, leaning);
    const auto normal = [&](const glm::dmat4& to_world) {
      scene.instances.front().to_world = to_world;
      const auto world = bake_world<TypeParam>(scene);
      return to_host(world.surface_point(this->below_diagonal(0.5, 0.25)).normal);
    };
    const auto expect = [&](const glm::dvec3& found, const glm::dvec3& right) {
      EXPECT_LT(glm::distance(found, right), 1e-6) << scale;
    };
    expect(normal(glm::dmat4(1.0)), expected);
    // A mirror image, and one that is turned about x: up becomes towards the viewer.
    expect(normal(glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1))), {-expected.x, expected.y, expected.z});
    expect(normal(glm::rotate(glm::dmat4(1.0), glm::radians(90.0), glm::dvec3(1, 0, 0))),
           {expected.x, -expected.z, expected.y});
    // Stretched tenfold along x, the same bumps are as high: only the normals' own rule would flatten them.
    expect(normal(glm::scale(glm::dmat4(1.0), glm::dvec3(10, 1, 1))), expected);
    // Tangents of the file count instead of the coordinates.
    scene.meshes.front().primitives.front().tangents.assign(4, {0, 1, 0, -1});
    expect(normal(glm::dmat4(1.0)), {expected.y, expected.x, expected.z});
  }
}

TYPED_TEST(MaterialBakerTest, WithoutADirectionOfTheCoordinatesANormalMapDoesNothing) {
  Material material = matte(glm::vec3(0.5F));
  material.normal_texture.image = 0;
  Scene scene = this->square_of(material, image_of({230, 77, 204, 255}));
  scene.meshes.front().primitives.front().uv[0].clear();
  place(scene, {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, matte(glm::vec3(0.5F)));
  const auto world = bake_world<TypeParam>(scene);
  for (const std::uint32_t triangle : {0U, 2U}) {
    Hit<TypeParam> hit = this->below_diagonal(0.5, 0.25);
    hit.triangle = triangle;
    EXPECT_EQ(to_host(world.surface_point(hit).normal), glm::dvec3(0, 0, 1));
  }
}

TYPED_TEST(MaterialBakerTest, AbsorptionIsThePowerOfTheColor) {
  constexpr double kScale = 0.125;  // baked lengths a metre
  Material material = glass();
  material.attenuation_color = {0.9F, 0.01F, 1.0F};
  material.attenuation_distance = 0.5F;
  const auto baked = MaterialBaker<TypeParam>({}, kScale, 0).bake(material);
  ASSERT_TRUE(baked.absorption);
  RandomInputs random(1);
  for (int i = 0; i < 200; ++i) {
    const double metres = random.log_uniform(1e-3, 8.0);
    const glm::dvec3 left =
        to_host(baked.absorption.transmittance(from_host<typename TypeParam::Length>(metres * kScale)));
    for (int c = 0; c < 3; ++c) {
      const double exact = std::pow(static_cast<double>(material.attenuation_color[c]), metres / 0.5);
      EXPECT_NEAR(left[c], exact, exact * bound<TypeParam>(2e-5, 2e-6)) << metres << ' ' << c;
    }
  }
  const auto nowhere = [&](Material m) {
    return !MaterialBaker<TypeParam>({}, kScale, 0).bake(m).absorption;
  };
  EXPECT_TRUE(nowhere(glass()));
  Material thin = material;
  thin.refracts = false;
  EXPECT_TRUE(nowhere(thin));
  Material white = material;
  white.attenuation_color = glm::vec3(1.0F);
  EXPECT_TRUE(nowhere(white));
  Material black = material;
  black.attenuation_color = glm::vec3(0.0F);
  const auto ink = MaterialBaker<TypeParam>({}, kScale, 0).bake(black).absorption;
  EXPECT_LT(to_host(ink.transmittance(from_host<typename TypeParam::Length>(1e-6))).x, 1e-6);
  EXPECT_EQ(to_host(ink.transmittance(typename TypeParam::Length(0))).x, 1.0);
}

// One texel for all: R weighs the coat, G its roughness, RGB colours specular reflection and sheen, A weighs
// the one and roughens the other. Only colours are by the sRGB curve.
TYPED_TEST(MaterialBakerTest, SpecularSheenAndCoatFollowTheirTextures) {
  const TextureUse texel{.image = 0, .nearest = true};
  Material material = matte(glm::vec3(0.5F));
  material.specular = 0.75F;
  material.specular_texture = texel;
  material.specular_color = glm::vec3(1, 2, 40);
  material.specular_color_texture = texel;
  material.sheen_color = glm::vec3(0.5F, 1, 1);
  material.sheen_color_texture = texel;
  material.sheen_roughness = 0.5F;
  material.sheen_roughness_texture = texel;
  material.clearcoat = 0.5F;
  material.clearcoat_texture = texel;
  material.clearcoat_roughness = 0.75F;
  material.clearcoat_roughness_texture = texel;
  const World<TypeParam> world =
      bake_world<TypeParam>(this->square_of(material, image_of({51, 102, 204, 153})));
  const auto at = [&](const World<TypeParam>& w) {
    const Hit<TypeParam> hit = this->below_diagonal(0.5, 0.25);
    return w.material(0).scattering(w.coordinates(0, hit.u, hit.v), false, w.srgb_table, w.linear_table);
  };
  const SurfaceScattering<TypeParam> s = at(world);
  const auto linear = [](double srgb) { return std::pow((srgb + 0.055) / 1.055, 2.4); };
  const glm::dvec3 color(linear(0.2), linear(0.4), linear(0.8));
  constexpr double kWeight = 0.75 * 0.6;
  const glm::dvec3 f0 = kWeight * glm::min(0.04 * glm::dvec3(1, 2, 40) * color, 1.0);
  EXPECT_LE(glm::length(to_host(s.f0) - f0), 1e-6);
  EXPECT_NEAR(to_host(s.f90), kWeight, 1e-6);
  ASSERT_NE(s.sheen.albedo, nullptr);
  EXPECT_LE(glm::length(to_host(s.sheen.color) - color * glm::dvec3(0.5, 1, 1)), 1e-6);
  EXPECT_NEAR(to_host(s.sheen.roughness), 0.5 * 0.6, 1e-6);
  EXPECT_NEAR(to_host(s.coat.weight), 0.5 * 0.2, 1e-6);
  EXPECT_NEAR(to_host(s.coat.alpha), std::pow(0.75 * 0.4, 2), 1e-6);
  EXPECT_FALSE(s.coat.smooth);

  const SurfaceScattering<TypeParam> plain = at(bake_world<TypeParam>(this->square_of(Material{})));
  EXPECT_EQ(plain.sheen.albedo, nullptr);
  EXPECT_EQ(to_host(plain.coat.weight), 0.0);
  Material mirror_coat;
  mirror_coat.clearcoat = 1.0F;
  EXPECT_TRUE(at(bake_world<TypeParam>(this->square_of(mirror_coat))).coat.smooth);
}

}  // namespace
}  // namespace vitrine
