// From a picture to the map that is traced: all light arrives, and from where it should.
#include "scene/environment_lattice.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/octahedral.h"
#include "number_systems.h"
#include "scene/bake.h"
#include "scene/made_scene.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

using std::numbers::pi;

EnvironmentPicture even_picture(int width, const glm::vec3& value) {
  EnvironmentPicture picture;
  picture.width = width;
  picture.height = width / 2;
  picture.values.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(width / 2), value);
  return picture;
}
glm::vec3& texel(EnvironmentPicture& picture, int x, int y) {
  return picture.values[static_cast<std::size_t>(y * picture.width + x)];
}

/// Noise, and a sun of one texel that outshines it.
EnvironmentPicture sunny_picture(int width) {
  EnvironmentPicture picture = even_picture(width, glm::vec3(0.0F));
  RandomInputs random(static_cast<std::uint64_t>(width));
  for (glm::vec3& value : picture.values) value = glm::vec3(random.in_cube(0.5) + 0.5);
  texel(picture, width * 5 / 8, picture.height / 4) =
      glm::vec3(1.0F, 0.7F, 0.4F) * static_cast<float>(width * width);
  return picture;
}

/// The integral over all directions of radiance times `weight(w)`, by the picture's texels.
template <class Weight>
glm::dvec3 integral_of_picture(const EnvironmentPicture& picture, const Weight& weight) {
  constexpr int kPieces = 4;
  glm::dvec3 sum(0.0);
  for (int y = 0; y < picture.height * kPieces; ++y) {
    const double top = pi * y / (picture.height * kPieces);
    const double bottom = pi * (y + 1) / (picture.height * kPieces);
    for (int x = 0; x < picture.width * kPieces; ++x) {
      const double azimuth = 2.0 * pi * ((x + 0.5) / (picture.width * kPieces) - 0.5) - picture.rotation_rad;
      const double polar = 0.5 * (top + bottom);
      const glm::dvec3 w(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                         std::sin(polar) * std::sin(azimuth));
      const double solid_angle = (std::cos(top) - std::cos(bottom)) * 2.0 * pi / (picture.width * kPieces);
      const auto index = static_cast<std::size_t>(y / kPieces * picture.width + x / kPieces);
      sum += glm::dvec3(picture.values[index]) * (picture.nits * solid_angle * weight(w));
    }
  }
  return sum;
}

/// The same by the blend of the lattice.
template <class Weight>
glm::dvec3 integral_of_lattice(const EnvironmentLattice& lattice, const Weight& weight) {
  constexpr int kPieces = 5;
  const int steps = lattice.cells * kPieces;
  glm::dvec3 sum(0.0);
  for (int row = 0; row < steps; ++row) {
    for (int column = 0; column < steps; ++column) {
      const double x = (column + 0.5) / kPieces;
      const double y = (row + 0.5) / kPieces;
      const glm::dvec3* upper =
          &lattice.radiance[static_cast<std::size_t>(row / kPieces * (lattice.cells + 1) + column / kPieces)];
      const glm::dvec3* lower = upper + lattice.cells + 1;
      const double u = x - column / kPieces;
      const double v = y - row / kPieces;
      const glm::dvec3 w = octahedral_direction(2.0 * x / lattice.cells - 1.0, 2.0 * y / lattice.cells - 1.0);
      const double density = std::pow(octahedral_point(w).taxicab, 3.0) * 4.0 / steps / steps;
      sum += glm::mix(glm::mix(upper[0], upper[1], u), glm::mix(lower[0], lower[1], u), v) *
             (density * weight(w));
    }
  }
  return sum;
}

TEST(EnvironmentLattice, KeepsTheFluxOfEachChannel) {
  const auto all = [](const glm::dvec3&) { return 1.0; };
  for (const int width : {2, 64, 300, 600}) {
    const EnvironmentPicture picture = sunny_picture(width);
    const glm::dvec3 sent = integral_of_picture(picture, all);
    const glm::dvec3 arrived = integral_of_lattice(make_environment_lattice(picture), all);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(arrived[c] / sent[c], 1.0, 2e-4) << width << ' ' << c;
  }
}

TEST(EnvironmentLattice, KeepsTheIrradianceFromEverySide) {
  RandomInputs random(6);
  EnvironmentPicture picture = sunny_picture(256);
  picture.rotation_rad = 1.0;
  const EnvironmentLattice lattice = make_environment_lattice(picture);
  for (int i = 0; i < 6; ++i) {
    const glm::dvec3 n = random.direction();
    const auto cosine = [&](const glm::dvec3& w) { return std::max(0.0, glm::dot(n, w)); };
    const glm::dvec3 sent = integral_of_picture(picture, cosine);
    const glm::dvec3 arrived = integral_of_lattice(lattice, cosine);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(arrived[c] / sent[c], 1.0, 5e-3) << i << ' ' << c;
  }
}

TEST(EnvironmentLattice, AnEvenPictureStaysEven) {
  for (const int width : {2, 64, 514}) {
    const EnvironmentLattice lattice =
        make_environment_lattice(even_picture(width, glm::vec3(1.0F, 0.5F, 0.0F)));
    for (const glm::dvec3& point : lattice.radiance) {
      ASSERT_NEAR(point.x, 1000.0, 1e-6);
      ASSERT_NEAR(point.y, 500.0, 1e-6);
      ASSERT_EQ(point.z, 0.0);
    }
  }
}

TEST(EnvironmentLattice, PointsOfTheRimThatAreOneDirectionAgree) {
  const EnvironmentLattice lattice = make_environment_lattice(sunny_picture(64));
  const int n = lattice.cells;
  const auto at = [&](int column, int row) {
    return lattice.radiance[static_cast<std::size_t>(row * (n + 1) + column)];
  };
  for (int i = 0; i <= n; ++i) {
    EXPECT_EQ(at(0, i), at(0, n - i));
    EXPECT_EQ(at(n, i), at(n, n - i));
    EXPECT_EQ(at(i, 0), at(n - i, 0));
    EXPECT_EQ(at(i, n), at(n - i, n));
  }
  EXPECT_EQ(at(0, 0), at(n, 0));
}

struct Landmark {
  double u;  ///< of the picture, from its left
  double v;  ///< from its top
  double rotation_deg;
  glm::dvec3 direction;
};

const std::vector<Landmark> kLandmarks{{0.5, 0.5, 0.0, {1, 0, 0}},   {0.75, 0.5, 0.0, {0, 0, 1}},
                                       {0.25, 0.5, 0.0, {0, 0, -1}}, {0.0, 0.5, 0.0, {-1, 0, 0}},
                                       {0.5, 0.0, 0.0, {0, 1, 0}},   {0.5, 1.0, 0.0, {0, -1, 0}},
                                       {0.5, 0.5, 90.0, {0, 0, -1}}, {0.75, 0.5, 90.0, {1, 0, 0}},
                                       {0.5, 0.5, -90.0, {0, 0, 1}}, {0.5, 0.25, 180.0, {-1, 1, 0}}};

// The world's environment, and that it is where the light comes from: in both number systems, in nits.
template <class N>
class BakedEnvironment : public testing::Test {};
TYPED_TEST_SUITE(BakedEnvironment, NumberSystems, NumberSystemNames);

TYPED_TEST(BakedEnvironment, ShinesFromWhereThePictureIsBright) {
  for (const Landmark& landmark : kLandmarks) {
    Scene scene;
    place(scene, {{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, matte(glm::vec3(0.5F)));
    scene.cameras.push_back(look_at({0, 0, 3}, {0, 0, 0}));
    EnvironmentPicture picture = even_picture(64, glm::vec3(0.25F));
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 64; ++x) {  // a spot of 4 texels around the landmark
        const double across = std::remainder((x + 0.5) / 64.0 - landmark.u, 1.0) * 64.0;
        const double down = (y + 0.5) - landmark.v * 32.0;
        if (std::abs(down) < 2.0 && (std::abs(across) < 2.0 || std::abs(landmark.v - 0.5) == 0.5))
          texel(picture, x, y) = glm::vec3(4.0F, 2.0F, 1.0F);
      }
    }
    picture.nits = 500.0;
    picture.rotation_rad = landmark.rotation_deg * pi / 180.0;
    scene.environment = Environment{glm::vec3(9e9F), glm::vec3(9e9F), glm::vec3(9e9F)};  // does not count
    scene.environment_picture = picture;
    const World<TypeParam> world = bake_world<TypeParam>(scene);
    ASSERT_TRUE(world.lights.sky);
    const auto nits = [&](const glm::dvec3& w) {
      const auto unit = from_host<typename TypeParam::Unit>(glm::normalize(w));
      return to_host(world.lights.sky->radiance(unit)) * std::ldexp(1.0, world.exponent);
    };
    EXPECT_LE(glm::length(nits(landmark.direction) - glm::dvec3(2000.0, 1000.0, 500.0)), 1.0)
        << landmark.u << ' ' << landmark.v << ' ' << landmark.rotation_deg;
    EXPECT_LE(glm::length(nits(-landmark.direction) - glm::dvec3(125.0)), 1.0);
    EXPECT_EQ(world.lights.size(), 1U);
  }
}

}  // namespace
}  // namespace vitrine
