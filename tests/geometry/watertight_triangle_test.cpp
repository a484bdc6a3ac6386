// One triangle against Cramer's rule in double precision.
#include "geometry/watertight_triangle.h"

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/host_conversion.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

struct Exact {
  double t, u, v;
};

// Solves origin + t d = a + u (b - a) + v (c - a).
Exact solve(const glm::dvec3& origin, const glm::dvec3& d, const glm::dvec3& a, const glm::dvec3& b,
            const glm::dvec3& c) {
  const glm::dmat3 matrix(-d, b - a, c - a);
  const glm::dvec3 x = glm::inverse(matrix) * (origin - a);
  return {x.x, x.y, x.z};
}

template <class N>
class WatertightTriangleTest : public testing::Test {
 protected:
  using Point = Vec3<typename N::Length>;

  static Point point(double x, double y, double z) {
    return from_host<typename N::Length>(glm::dvec3(x, y, z));
  }
  static Hit<N> intersect(const Point& origin, const glm::dvec3& direction, const Point& a, const Point& b,
                          const Point& c, double t_max = 7.0) {
    const Ray<N> ray{origin, from_host<typename N::Unit>(direction), from_host<typename N::Length>(t_max)};
    Hit<N> hit{.t = ray.t_max};
    if (ShearedRay<N>(ray).intersect(a, b, c, hit)) hit.triangle = 0;
    return hit;
  }
};
TYPED_TEST_SUITE(WatertightTriangleTest, NumberSystems, NumberSystemNames);

TYPED_TEST(WatertightTriangleTest, FindsWhatCramersRuleFinds) {
  RandomInputs random(1);
  int hits = 0;
  for (int i = 0; i < 300000; ++i) {
    const auto vertex = [&] { return from_host<typename TypeParam::Length>(random.in_cube()); };
    const auto a = vertex();
    const auto b = vertex();
    const auto c = vertex();
    const auto origin = vertex();
    const auto d = to_host(from_host<typename TypeParam::Unit>(random.direction()));
    const glm::dvec3 facing = glm::cross(to_host(b) - to_host(a), to_host(c) - to_host(a));
    if (std::abs(glm::dot(facing, d)) < 0.02) continue;  // nearly edge-on: ill-conditioned
    const Exact exact = solve(to_host(origin), d, to_host(a), to_host(b), to_host(c));
    const double inside = std::min({exact.u, exact.v, 1.0 - exact.u - exact.v, exact.t});
    if (std::abs(inside) < 1e-4) continue;  // on an edge, or at it
    const Hit<TypeParam> hit = this->intersect(origin, d, a, b, c);
    ASSERT_EQ(static_cast<bool>(hit), inside > 0.0);
    if (!hit) continue;
    ++hits;
    const double tolerance = bound<TypeParam>(5e-5, 1e-6);
    ASSERT_NEAR(to_host(hit.t), exact.t, tolerance);
    ASSERT_NEAR(to_host(hit.u), exact.u, tolerance);
    ASSERT_NEAR(to_host(hit.v), exact.v, tolerance);
  }
  EXPECT_GT(hits, 5000);
}

TYPED_TEST(WatertightTriangleTest, IsHitFromEitherSideAndWithinTMax) {
  const auto a = this->point(0.0, 0.0, 0.5);
  const auto b = this->point(1.0, 0.0, 0.5);
  const auto c = this->point(0.0, 1.0, 0.5);
  const auto below = this->point(0.25, 0.25, 0.0);
  const auto above = this->point(0.25, 0.25, 1.0);
  const glm::dvec3 up(0, 0, 1);
  EXPECT_TRUE(this->intersect(below, up, a, b, c));
  EXPECT_TRUE(this->intersect(above, -up, a, b, c));
  EXPECT_TRUE(this->intersect(below, up, a, c, b));
  EXPECT_FALSE(this->intersect(below, -up, a, b, c)) << "behind the origin";
  EXPECT_FALSE(this->intersect(below, up, a, b, c, 0.5)) << "at t_max";
  EXPECT_TRUE(this->intersect(below, up, a, b, c, 0.501));
  EXPECT_FALSE(this->intersect(this->point(0.25, 0.25, 0.5), up, a, b, c)) << "at the origin";
}

TYPED_TEST(WatertightTriangleTest, EdgesAndCornersCount) {
  const auto a = this->point(0.0, 0.0, 0.5);
  const auto b = this->point(1.0, 0.0, 0.5);
  const auto c = this->point(0.0, 1.0, 0.5);
  const glm::dvec3 up(0, 0, 1);
  for (const auto& p :
       {this->point(0.0, 0.0, 0.0), this->point(1.0, 0.0, 0.0), this->point(0.0, 1.0, 0.0),
        this->point(0.5, 0.0, 0.0), this->point(0.5, 0.5, 0.0), this->point(0.0, 0.25, 0.0)}) {
    const Hit<TypeParam> hit = this->intersect(p, up, a, b, c);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(to_host(hit.t), 0.5, 1e-7);
  }
}

TYPED_TEST(WatertightTriangleTest, WithoutAreaIsNeverHit) {
  const auto a = this->point(0.0, 0.0, 0.5);
  const auto b = this->point(1.0, 0.0, 0.5);
  const glm::dvec3 up(0, 0, 1);
  EXPECT_FALSE(this->intersect(this->point(0.0, 0.0, 0.0), up, a, a, a));
  EXPECT_FALSE(this->intersect(this->point(0.5, 0.0, 0.0), up, a, b, b));
  EXPECT_FALSE(this->intersect(this->point(0.5, 0.0, 0.0), up, a, b, this->point(0.5, 0.0, 0.5)));
  EXPECT_FALSE(this->intersect(this->point(0.5, 0.0, 0.0), up, a, b, this->point(0.5, 0.0, 1.0)))
      << "edge-on";
}

}  // namespace
}  // namespace vitrine
