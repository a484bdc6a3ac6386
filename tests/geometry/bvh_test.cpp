// The hierarchy against all triangles one by one: it may leave out nothing and add nothing.
#include "geometry/bvh.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "geometry/meshes.h"
#include "number_systems.h"

namespace vitrine {
namespace {

template <class N, class Counts>
Hit<N> brute_force(const Bvh<N>& bvh, const Ray<N>& ray, const Counts& counts) {
  Hit<N> hit{.t = ray.t_max};
  const ShearedRay<N> sheared(ray);
  for (std::uint32_t i = 0; i < bvh.triangles().size(); ++i) {
    const glm::uvec3& t = bvh.triangles()[i];
    Hit<N> nearer = hit;
    if (!sheared.intersect(bvh.positions()[t.x], bvh.positions()[t.y], bvh.positions()[t.z], nearer))
      continue;
    nearer.triangle = i;
    if (counts(ray, nearer)) hit = nearer;
  }
  return hit;
}

template <class N>
class BvhTest : public testing::Test {
 protected:
  using Unit = typename N::Unit;
  using Length = typename N::Length;

  static Bvh<N> build(const TestMesh& mesh) { return Bvh<N>(baked_positions<N>(mesh), mesh.triangles); }

  // From within or around +-1 to a point on or near a triangle; most with zeros of either sign, which lead
  // past it.
  static Ray<N> random_ray(const TestMesh& mesh, RandomInputs& random) {
    glm::dvec3 origin = random.in_cube(random.index(2) == 0 ? 1.0 : 1.5);
    const glm::uvec3& t = mesh.triangles[random.index(mesh.triangles.size())];
    const double u = random.uniform(-0.2, 1.2);
    const double v = random.uniform(-0.2, 1.2);
    const glm::dvec3 target =
        mesh.positions[t.x] * (1.0 - u - v) + mesh.positions[t.y] * u + mesh.positions[t.z] * v;
    const std::uint32_t zeros = random.index(16);
    if (zeros < 7) {
      for (int axis = 0; axis < 3; ++axis) {
        if ((zeros >> axis & 1U) != 0) origin[axis] = target[axis];
      }
    }
    glm::dvec3 d = glm::normalize(target - origin);
    for (int axis = 0; axis < 3; ++axis) {
      if (d[axis] == 0.0 && random.index(2) == 0) d[axis] = -0.0;
    }
    const double t_max = random.index(4) == 0 ? random.uniform(0.1, 2.0) : 7.0;
    return {from_host<Length>(origin), from_host<Unit>(d), from_host<Length>(t_max)};
  }

  static std::vector<Ray<N>> random_rays(const TestMesh& mesh) {
    RandomInputs random(1);
    std::vector<Ray<N>> rays;
    for (int i = 0; i < 4000; ++i) rays.push_back(random_ray(mesh, random));
    return rays;
  }
  static void compare_random_rays(const TestMesh& mesh) { compare(build(mesh), random_rays(mesh), 800); }

  template <class Counts = EveryHit>
  static void compare(const Bvh<N>& bvh, const std::vector<Ray<N>>& rays, std::size_t fewest_hits,
                      const Counts& counts = {}) {
    std::vector<Hit<N>> hits(rays.size());
    std::vector<std::uint8_t> occluded(rays.size(), 2);
    bvh.closest(rays, hits, counts);
    bvh.occluded(rays, occluded, counts);
    std::size_t found = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Hit<N> exact = brute_force(bvh, rays[i], counts);
      ASSERT_EQ(static_cast<bool>(hits[i]), static_cast<bool>(exact)) << "ray " << i;
      ASSERT_EQ(occluded[i], exact ? 1 : 0) << "ray " << i;
      ASSERT_EQ(hits[i].t, exact.t) << "ray " << i;
      if (!exact) continue;
      ++found;
      if (hits[i].triangle == exact.triangle) {  // else two triangles at the same distance
        ASSERT_EQ(hits[i].u, exact.u);
        ASSERT_EQ(hits[i].v, exact.v);
      }
    }
    EXPECT_GE(found, fewest_hits);
  }
};
TYPED_TEST_SUITE(BvhTest, NumberSystems, NumberSystemNames);

TYPED_TEST(BvhTest, RandomSoups) {
  for (const std::size_t count : {1U, 2U, 9U, 100U, 2000U})
    this->compare_random_rays(soup(count, 0.3, count));
}

TYPED_TEST(BvhTest, OfNothingIsNeverHit) {
  const TestMesh nothing;
  RandomInputs random(2);
  const std::vector<Ray<TypeParam>> rays(10, this->random_ray(soup(1, 0.5, 1), random));
  this->compare(Bvh<TypeParam>(), rays, 0);
  this->compare(this->build(nothing), rays, 0);
}

// Planes along the axes have boxes without thickness.
TYPED_TEST(BvhTest, AxisAlignedPlanes) {
  for (const int axis : {0, 1, 2}) {
    glm::dvec3 half_extent(0.75);
    half_extent[axis] = 0.0;
    this->compare_random_rays(box(half_extent, 8));
  }
}

TYPED_TEST(BvhTest, RaysWithinAPlane) {
  const TestMesh plane = box({0.75, 0.0, 0.75}, 4);
  RandomInputs random(4);
  std::vector<Ray<TypeParam>> rays;
  for (int i = 0; i < 2000; ++i) {
    Ray<TypeParam> ray = this->random_ray(plane, random);
    const double angle = random.uniform(0.0, 6.3);
    ray.origin.y = typename TypeParam::Length(0);
    ray.direction = from_host<typename TypeParam::Unit>(glm::dvec3(std::cos(angle), 0.0, std::sin(angle)));
    rays.push_back(ray);
  }
  this->compare(this->build(plane), rays, 0);
}

TYPED_TEST(BvhTest, Degenerate) {
  TestMesh mesh = soup(200, 0.3, 5);
  for (std::uint32_t i = 0; i < 100; ++i) {  // points and lines among the triangles, and triangles twice
    const glm::uvec3 t = mesh.triangles[i];
    mesh.triangles.insert(mesh.triangles.end(), {{t.x, t.x, t.x}, {t.x, t.y, t.y}, t});
  }
  this->compare_random_rays(mesh);
}

// A hit that does not count lets the ray go on to the next, whatever the decision looks at.
TYPED_TEST(BvhTest, OnlyHitsThatCount) {
  using R = Ray<TypeParam>;
  using H = Hit<TypeParam>;
  const TestMesh mesh = soup(500, 0.5, 6);
  const Bvh<TypeParam> bvh = this->build(mesh);
  const std::vector<R> rays = this->random_rays(mesh);
  this->compare(bvh, rays, 800, [](const R&, const H& hit) { return hit.triangle % 3 == 0; });
  this->compare(bvh, rays, 800, [](const R&, const H& hit) { return hit.u < hit.v; });
  this->compare(bvh, rays, 400, [](const R& ray, const H&) { return ray.direction.x > 0; });
  this->compare(bvh, rays, 0, [](const R&, const H&) { return false; });
  const auto hits = [&](const auto& counts) {
    std::vector<H> found(rays.size());
    bvh.closest(rays, found, counts);
    return std::ranges::count_if(found, [](const H& hit) { return bool{hit}; });
  };
  EXPECT_LT(hits([](const R&, const H& hit) { return hit.triangle % 3 == 0; }), hits(EveryHit{}));
  EXPECT_EQ(hits([](const R&, const H&) { return false; }), 0);
}

TYPED_TEST(BvhTest, ManyAroundOneCenter) {
  TestMesh mesh;
  for (int i = 1; i <= 64; ++i) {
    const TestMesh shell = box(glm::dvec3(0.9 * i / 64.0), 1);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), shell.positions.begin(), shell.positions.end());
    for (const glm::uvec3& t : shell.triangles) mesh.triangles.push_back(t + first);
  }
  this->compare_random_rays(mesh);
}

}  // namespace
}  // namespace vitrine
