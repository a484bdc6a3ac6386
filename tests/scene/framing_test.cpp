#include "scene/framing.h"

#include <cmath>

#include <gtest/gtest.h>

namespace vitrine {
namespace {

TEST(Framing, SeesAllOfABox) {
  for (const glm::dvec3& size : {glm::dvec3(1, 1, 1), glm::dvec3(1e-3, 5, 1e-3), glm::dvec3(1e4, 1, 300)}) {
    const Bounds bounds{glm::dvec3(100, -20, 3), glm::dvec3(100, -20, 3) + size};
    const CameraView view = framing_camera(bounds);
    const glm::dmat4 to_camera = glm::inverse(view.to_world);
    double widest = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p(corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
                         corner & 4 ? bounds.high.z : bounds.low.z);
      const glm::dvec3 seen(to_camera * glm::dvec4(p, 1.0));
      ASSERT_LT(seen.z, 0.0) << "in front of the camera";
      widest = std::max({widest, std::abs(seen.x / seen.z), std::abs(seen.y / seen.z)});
    }
    EXPECT_LT(widest, std::tan(0.5 * view.yfov_rad));
    EXPECT_GT(widest, 0.4 * std::tan(0.5 * view.yfov_rad)) << "and not from too far";
  }
}

TEST(Framing, LooksFromTheFrontRightAndAbove) {
  const CameraView view = framing_camera({glm::dvec3(-1), glm::dvec3(1)});
  EXPECT_GT(view.to_world[3].x, 0);
  EXPECT_GT(view.to_world[3].y, 0);
  EXPECT_GT(view.to_world[3].z, 0);
  EXPECT_GT(view.to_world[1].y, 0) << "up is up";
}

TEST(Framing, BoundsFollowTransforms) {
  Scene scene;
  scene.meshes.emplace_back().primitives.emplace_back().positions = {glm::vec3(0), glm::vec3(1, 2, 3)};
  glm::dmat4 mirrored_and_moved(1.0);
  mirrored_and_moved[0][0] = -1.0;
  mirrored_and_moved[3] = glm::dvec4(10, 0, 0, 1);
  scene.instances.push_back({"", 0, mirrored_and_moved});
  const Bounds bounds = world_bounds(scene);
  EXPECT_EQ(bounds.low, glm::dvec3(9, 0, 0));
  EXPECT_EQ(bounds.high, glm::dvec3(10, 2, 3));
}

}  // namespace
}  // namespace vitrine
