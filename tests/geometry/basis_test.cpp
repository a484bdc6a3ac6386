#include "geometry/basis.h"

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/host_conversion.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

template <class N>
class BasisTest : public testing::Test {
 protected:
  static void expect_orthonormal(const glm::dvec3& normal) {
    using Unit = typename N::Unit;
    const auto n = from_host<Unit>(normal);
    const Basis<N> basis(n);
    const glm::dvec3 x = to_host(basis.to_world({Unit(1), Unit(0), Unit(0)}));
    const glm::dvec3 y = to_host(basis.to_world({Unit(0), Unit(1), Unit(0)}));
    const glm::dvec3 z = to_host(basis.to_world({Unit(0), Unit(0), Unit(1)}));
    const double tolerance = bound<N>(5e-7, 1.5e-8);
    ASSERT_EQ(basis.normal(), n);
    ASSERT_EQ(basis.to_world({Unit(0), Unit(0), Unit(1)}), n);
    for (const glm::dvec3& axis : {x, y, z}) ASSERT_NEAR(glm::length(axis), 1.0, tolerance) << normal.z;
    ASSERT_NEAR(glm::dot(x, y), 0.0, tolerance) << normal.z;
    ASSERT_NEAR(glm::dot(y, z), 0.0, tolerance) << normal.z;
    ASSERT_NEAR(glm::dot(z, x), 0.0, tolerance) << normal.z;
    ASSERT_NEAR(glm::dot(glm::cross(x, y), z), 1.0, 2 * tolerance) << "right-handed " << normal.z;
    // There and back again.
    const glm::dvec3 v = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
    const glm::dvec3 back = to_host(basis.to_local(basis.to_world(from_host<Unit>(v))));
    ASSERT_LE(glm::length(back - v), 2 * tolerance) << normal.z;
  }
};
TYPED_TEST_SUITE(BasisTest, NumberSystems, NumberSystemNames);

TYPED_TEST(BasisTest, IsOrthonormalAroundAnyNormal) {
  RandomInputs random(1);
  for (int i = 0; i < 200000; ++i) this->expect_orthonormal(random.direction());
}

TYPED_TEST(BasisTest, IsOrthonormalAroundTheAxesAndNearThem) {
  for (const double sign : {1.0, -1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 n(0.0);
      n[axis] = sign;
      this->expect_orthonormal(n);
      for (const double aside : {1e-9, 1e-7, 1e-4, -1e-4, -1e-7, -1e-9}) {
        glm::dvec3 near = n;
        near[(axis + 1) % 3] = aside;
        near[(axis + 2) % 3] = -2.0 * aside;
        this->expect_orthonormal(glm::normalize(near));
      }
    }
  }
}

}  // namespace
}  // namespace vitrine
