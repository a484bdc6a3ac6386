// Tangents from texture coordinates: along growing u, on the side of the surface's front that falling v
// tells, blended where triangles share a vertex and split where mirrored and unmirrored ones do.
#include "scene/tangents.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace vitrine {
namespace {

void expect_near(const glm::vec3& found, const glm::vec3& expected) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-6) << c;
}

// (0,0) to (1,1) in the plane z = 0, front to +z, upright: u along x, v along -y.
Primitive upright_square() {
  Primitive primitive;
  primitive.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  primitive.normals.assign(4, {0, 0, 1});
  primitive.uv[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  primitive.triangles = {{0, 1, 2}, {0, 2, 3}};
  return primitive;
}

TEST(Tangents, OfAnUprightImageRunAlongItsRows) {
  const Primitive square = with_tangents(upright_square(), {});
  ASSERT_EQ(square.tangents.size(), 4U);
  for (const glm::vec4& tangent : square.tangents) {
    expect_near(tangent, {1, 0, 0});
    EXPECT_EQ(tangent.w, 1.0F);  // cross(+z, +x) = +y: where v falls
  }
}

TEST(Tangents, OfAMirroredImageHaveTheirBitangentOnTheOtherSide) {
  Primitive square = upright_square();
  for (glm::vec2& uv : square.uv[0]) uv.x = 1 - uv.x;
  for (const glm::vec4& tangent : with_tangents(square, {}).tangents) {
    expect_near(tangent, {-1, 0, 0});
    EXPECT_EQ(tangent.w, -1.0F);
  }
}

TEST(Tangents, FollowTheSetAndTheTransformOfTheMap) {
  Primitive square = upright_square();
  square.uv[1] = square.uv[0];
  square.uv[0].assign(4, {0.5F, 0.5F});
  TextureUse use;
  use.texcoord = 1;
  use.transform = glm::mat3(0, 1, 0, -1, 0, 0, 0, 0, 1);  // (u, v) to (-v, u), by columns
  for (const glm::vec4& tangent : with_tangents(square, use).tangents) {
    expect_near(tangent, {0, 1, 0});
    EXPECT_EQ(tangent.w, 1.0F);
  }
  use.texcoord = 0;
  for (const glm::vec4& tangent : with_tangents(square, use).tangents) expect_near(tangent, {0, 0, 0});
  square.uv[0].clear();
  for (const glm::vec4& tangent : with_tangents(square, use).tangents) expect_near(tangent, {0, 0, 0});
}

// Two squares side by side, the right one a mirror image: they share the vertices of the seam.
TEST(Tangents, VerticesOfAMirrorSeamAreSplit) {
  Primitive both = upright_square();
  both.positions.insert(both.positions.end(), {{2, 0, 0}, {2, 1, 0}});
  both.normals.assign(6, {0, 0, 1});
  both.uv[0].insert(both.uv[0].end(), {{0, 1}, {0, 0}});
  both.colors.assign(6, glm::vec3(0.5F));
  both.alphas = {0.0F, 0.1F, 0.2F, 0.3F, 0.4F, 0.5F};
  both.triangles.insert(both.triangles.end(), {{1, 4, 5}, {1, 5, 2}});
  const Primitive made = with_tangents(both, {});
  ASSERT_EQ(made.positions.size(), 8U);
  for (const std::size_t size : {made.normals.size(), made.uv[0].size(), made.colors.size(),
                                 made.alphas.size(), made.tangents.size()}) {
    EXPECT_EQ(size, 8U);
  }
  EXPECT_TRUE(made.uv[1].empty());
  for (std::size_t t = 0; t < 4; ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = made.triangles[t][corner];
      const std::uint32_t original = both.triangles[t][corner];
      EXPECT_EQ(made.positions[vertex], both.positions[original]);
      EXPECT_EQ(made.uv[0][vertex], both.uv[0][original]);
      EXPECT_EQ(made.alphas[vertex], both.alphas[original]);
      expect_near(made.tangents[vertex], {t < 2 ? 1 : -1, 0, 0});
      EXPECT_EQ(made.tangents[vertex].w, t < 2 ? 1.0F : -1.0F);
    }
  }
}

// Around vertex 0 an upright triangle of 90 degrees and a slanted, far larger one of 45.
TEST(Tangents, AreBlendedByAngles) {
  Primitive fan;
  fan.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-4, 4, 0}};
  fan.normals.assign(4, {0, 0, 1});
  fan.uv[0] = {{0, 1}, {1, 1}, {0, 0}, {-4, 1}};
  fan.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Primitive made = with_tangents(fan, {});
  ASSERT_EQ(made.positions.size(), 4U);
  const float s = std::sqrt(0.5F);
  expect_near(made.tangents[1], {1, 0, 0});
  expect_near(made.tangents[3], {s, -s, 0});
  expect_near(made.tangents[0], glm::normalize(glm::vec3(2 + s, -s, 0)));
}

// Under a normal that leans, a tangent leans too, and what is left of it in that plane does not count for
// less.
TEST(Tangents, ArePerpendicularToTheNormal) {
  Primitive square = upright_square();
  square.normals[0] = glm::normalize(glm::vec3(0.75F, 0.5F, 1.0F));
  const Primitive made = with_tangents(square, {});
  const glm::vec3 along(made.tangents[0]);
  const glm::vec3 normal = square.normals[0];
  EXPECT_NEAR(glm::dot(along, normal), 0.0F, 1e-6);
  expect_near(along, glm::normalize(glm::vec3(1, 0, 0) - normal * normal.x));
}

TEST(Tangents, FlatTrianglesShareNoVertex) {
  Primitive square = upright_square();
  square.normals.clear();
  square.positions[3] = {0, 1, 1};  // the second triangle is bent up
  const Primitive made = with_tangents(square, {});
  ASSERT_EQ(made.positions.size(), 6U);
  EXPECT_TRUE(made.normals.empty());
  for (const std::uint32_t vertex : {made.triangles[0].x, made.triangles[0].y, made.triangles[0].z}) {
    expect_near(made.tangents[vertex], {1, 0, 0});
  }
  for (const std::uint32_t vertex : {made.triangles[1].x, made.triangles[1].y, made.triangles[1].z}) {
    expect_near(made.tangents[vertex], glm::normalize(glm::vec3(1, 0, -1)));
  }
}

}  // namespace
}  // namespace vitrine
