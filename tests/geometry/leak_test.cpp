// Closed meshes hold every ray that starts inside, even one aimed exactly at an edge or a vertex that several
// triangles share.
#include <gtest/gtest.h>

#include "geometry/meshes.h"
#include "number_systems.h"

namespace vitrine {
namespace {

constexpr std::size_t kRays = 60000;  // a mesh

template <class N>
class LeakTest : public testing::Test {
 protected:
  using Unit = typename N::Unit;
  using Length = typename N::Length;

  // `mesh`: closed, convex around the origin.
  static void expect_tight(const TestMesh& mesh) {
    const Bvh<N> bvh(baked_positions<N>(mesh), mesh.triangles);
    const auto positions = bvh.positions();
    const std::vector<glm::uvec2> edges = mesh.edges();
    RandomInputs random(1);
    std::vector<Ray<N>> rays;
    for (std::size_t i = 0; i < kRays; ++i) {
      const Vec3<Length> origin = from_host<Length>(inside(mesh, random));
      const glm::uvec2 edge = edges[random.index(edges.size())];
      const Vec3<Length> along = positions[edge.y] - positions[edge.x];
      Vec3<Length> target = positions[edge.x];
      if (i % 3 == 1) target = target + along * Unit(0.5);
      if (i % 3 == 2) target = target + along * from_host<Unit>(random.uniform());
      rays.push_back({origin, normalize(target - origin), far_away<N>()});
    }
    std::vector<Hit<N>> hits(rays.size());
    std::vector<std::uint8_t> occluded(rays.size());
    bvh.closest(rays, hits);
    bvh.occluded(rays, occluded);
    std::size_t leaks = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) leaks += !hits[i] || occluded[i] == 0 ? 1U : 0U;
    EXPECT_EQ(leaks, 0U);
  }

  // The centre, a point on an axis, or anywhere from there to just under the surface.
  static glm::dvec3 inside(const TestMesh& mesh, RandomInputs& random) {
    const std::uint32_t kind = random.index(16);
    if (kind == 0) return glm::dvec3(0.0);
    const glm::uvec3& t = mesh.triangles[random.index(mesh.triangles.size())];
    const double u = random.uniform();
    const double v = random.uniform(0.0, 1.0 - u);
    const glm::dvec3 surface =
        mesh.positions[t.x] * (1.0 - u - v) + mesh.positions[t.y] * u + mesh.positions[t.z] * v;
    return surface * (kind == 1 ? 0.999 : random.uniform(0.0, 0.98));
  }
};
TYPED_TEST_SUITE(LeakTest, NumberSystems, NumberSystemNames);

TYPED_TEST(LeakTest, FineSphere) { this->expect_tight(icosphere(4, 0.9)); }
TYPED_TEST(LeakTest, CoarseSphere) { this->expect_tight(icosphere(1, 0.99)); }
TYPED_TEST(LeakTest, TinySphere) { this->expect_tight(icosphere(2, 0.002)); }
TYPED_TEST(LeakTest, LargeTriangles) { this->expect_tight(box(glm::dvec3(0.999), 1)); }
TYPED_TEST(LeakTest, FineBox) { this->expect_tight(box({0.7, 0.31, 0.53}, 16)); }
TYPED_TEST(LeakTest, ThinBox) { this->expect_tight(box({0.9, 1.0 / 512, 0.8}, 12)); }
TYPED_TEST(LeakTest, Needle) { this->expect_tight(box({0.004, 0.99, 0.003}, 3)); }

}  // namespace
}  // namespace vitrine
