// Camera rays against the pinhole and the parallel projection computed in double.
#include "scene/camera.h"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "number_systems.h"
#include "scene/bake.h"
#include "scene/made_scene.h"

namespace vitrine {
namespace {

template <class N>
class CameraOf : public testing::Test {
 protected:
  using Unit = typename N::Unit;

  struct HostRay {
    glm::dvec3 origin;  ///< metres
    glm::dvec3 direction;
  };
  /// The ray of `view` through pixel (x, y) at (u, v), in a scene around (3, 1, -2).
  static HostRay ray(const CameraView& view, int width, int height, std::uint32_t x, std::uint32_t y,
                     double u, double v) {
    Scene scene;
    place(scene, {{2, 0, -2}, {2, 0, 0}, {0, 2, 0}}, matte(glm::vec3(0.5F)));
    scene.cameras.push_back(view);
    const World<N> world = bake_world<N>(scene);
    const Ray<N> ray =
        bake_camera(view, world, width, height).ray(x, y, from_host<Unit>(u), from_host<Unit>(v));
    EXPECT_GT(to_host(ray.t_max), 2.0 * std::sqrt(3.0));
    return {to_host(ray.origin) / world.scale + world.center, to_host(ray.direction)};
  }
  static void expect_near(const glm::dvec3& found, const glm::dvec3& expected) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-6) << c;
  }
};
TYPED_TEST_SUITE(CameraOf, NumberSystems, NumberSystemNames);

const glm::dvec3 kEye(1.0, 1.5, 2.0);

TYPED_TEST(CameraOf, PerspectiveLooksAlongMinusZWithYUp) {
  const double yfov = 0.9;
  const CameraView view = look_at(kEye, {3, 1, -2}, yfov);
  const glm::dmat3 axes(view.to_world);
  const double half = std::tan(yfov / 2);
  for (const std::uint32_t x : {0U, 3U, 7U}) {
    for (const std::uint32_t y : {0U, 2U, 3U}) {
      const auto ray = this->ray(view, 8, 4, x, y, 0.25, 0.75);
      const glm::dvec3 d(((x + 0.25) / 8 * 2 - 1) * half * 2.0, (1 - (y + 0.75) / 4 * 2) * half, -1.0);
      this->expect_near(ray.origin, kEye);
      this->expect_near(ray.direction, axes * glm::normalize(d));
    }
  }
}

TYPED_TEST(CameraOf, OrthographicRaysAreParallel) {
  const CameraView view = close_up(kEye, {3, 1, -2}, 0.5);
  const glm::dmat3 axes(view.to_world);
  for (const std::uint32_t x : {0U, 5U}) {
    for (const std::uint32_t y : {0U, 5U}) {
      const auto ray = this->ray(view, 6, 6, x, y, 0.5, 0.5);
      const glm::dvec3 offset((x + 0.5) / 6 - 0.5, 0.5 - (y + 0.5) / 6, 0.0);
      this->expect_near(ray.origin, kEye + axes * offset);
      this->expect_near(ray.direction, -axes[2]);
    }
  }
}

// A camera that promises an aspect shows at least that much: a narrower film sees more above and below.
TYPED_TEST(CameraOf, PromisedAspectStaysVisible) {
  CameraView view = look_at(kEye, {3, 1, -2}, 0.8);
  const glm::dmat3 axes(view.to_world);
  const double half = std::tan(0.4);
  const auto slopes = [&](int width, int height) {  // of the film's top left corner
    const glm::dvec3 d = glm::transpose(axes) * this->ray(view, width, height, 0, 0, 0.0, 0.0).direction;
    return glm::dvec2(d.x / d.z, d.y / -d.z);
  };
  view.aspect = 1.5;
  EXPECT_NEAR(slopes(300, 200).x, 1.5 * half, 1e-5);
  EXPECT_NEAR(slopes(300, 200).y, half, 1e-5);
  EXPECT_NEAR(slopes(400, 200).x, 2.0 * half, 1e-5);  // wider: more at the sides
  EXPECT_NEAR(slopes(400, 200).y, half, 1e-5);
  EXPECT_NEAR(slopes(200, 200).x, 1.5 * half, 1e-5);  // narrower: more above and below
  EXPECT_NEAR(slopes(200, 200).y, 1.5 * half, 1e-5);
  view.aspect.reset();
  EXPECT_NEAR(slopes(200, 200).x, half, 1e-5);
}

TYPED_TEST(CameraOf, OrthographicMagnificationsStayVisible) {
  CameraView view = close_up(kEye, {3, 1, -2}, 0.5);
  view.xmag = 1.0;
  const glm::dmat3 axes(view.to_world);
  const auto corner = [&](int width, int height) {
    return glm::transpose(axes) * (this->ray(view, width, height, 0, 0, 0.0, 0.0).origin - kEye);
  };
  this->expect_near(corner(200, 100), {-1.0, 0.5, 0.0});
  this->expect_near(corner(100, 100), {-1.0, 1.0, 0.0});
  this->expect_near(corner(300, 100), {-1.5, 0.5, 0.0});
}

TYPED_TEST(CameraOf, AWideAngleKeepsUnitDirections) {
  const CameraView view = look_at(kEye, {3, 1, -2}, 3.0);
  const glm::dmat3 axes(view.to_world);
  for (const std::uint32_t x : {0U, 63U}) {
    const auto ray = this->ray(view, 64, 16, x, 0, 0.5, 0.5);
    const double half = std::tan(1.5);
    const glm::dvec3 d(((x + 0.5) / 64 * 2 - 1) * half * 4.0, (1 - 0.5 / 16 * 2) * half, -1.0);
    EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-6);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(ray.direction[c], (axes * glm::normalize(d))[c], 2e-6);
  }
}

TYPED_TEST(CameraOf, AScaledNodeChangesNothing) {
  CameraView view = look_at(kEye, {3, 1, -2}, 0.8);
  const auto plain = this->ray(view, 8, 8, 1, 2, 0.5, 0.5);
  for (int axis = 0; axis < 3; ++axis) view.to_world[axis] *= 3.0;
  const auto scaled = this->ray(view, 8, 8, 1, 2, 0.5, 0.5);
  this->expect_near(scaled.direction, plain.direction);
  this->expect_near(scaled.origin, plain.origin);
}

}  // namespace
}  // namespace vitrine
