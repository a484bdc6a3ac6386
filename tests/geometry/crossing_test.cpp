// The random number of a ray and a triangle: as likely everywhere, independent between rays and triangles
// however alike they are, and always the same.
#include "geometry/crossing.h"

#include <vector>

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/host_conversion.h"
#include "statistics/chi_square.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

template <class N>
class CrossingTest : public testing::Test {
 protected:
  using Unit = typename N::Unit;
  using Length = typename N::Length;
  static constexpr std::size_t kCells = 16;

  static Ray<N> ray(const glm::dvec3& origin, const glm::dvec3& direction) {
    return {from_host<Length>(origin), from_host<Unit>(direction), far_away<N>()};
  }
  static std::size_t cell(const Ray<N>& ray, std::uint32_t triangle) {
    return crossing_bits(ray, triangle) >> 28;
  }
};
TYPED_TEST_SUITE(CrossingTest, NumberSystems, NumberSystemNames);

// Neighbouring rays of a camera, and of an orthographic one, through the same triangle.
TYPED_TEST(CrossingTest, IsUniformOverRaysThatHardlyDiffer) {
  constexpr int kSide = 200;
  std::vector<std::uint64_t> turned(this->kCells);
  std::vector<std::uint64_t> moved(this->kCells);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const glm::dvec3 step(x * 0x1p-20, y * 0x1p-20, 0.0);
      ++turned[this->cell(this->ray({0, 0, 0.5}, glm::dvec3(0.25, 0.25, -0.875) + step), 7)];
      ++moved[this->cell(this->ray(glm::dvec3(0.25, 0.25, 0.5) + step, {0, 0, -1}), 7)];
    }
  }
  EXPECT_GT(chi_square_uniform(turned).p_value, sidak(8));
  EXPECT_GT(chi_square_uniform(moved).p_value, sidak(8));
}

// The sheets of a stack must let through independently of each other: their indices differ by 1, 2, ...
TYPED_TEST(CrossingTest, IsIndependentBetweenTriangles) {
  RandomInputs random(1);
  for (const std::uint32_t apart : {1U, 2U, 256U}) {
    std::vector<std::uint64_t> both(this->kCells * this->kCells);
    for (int i = 0; i < 50000; ++i) {
      const auto ray = this->ray(random.in_cube(), random.direction());
      ++both[this->cell(ray, 12) * this->kCells + this->cell(ray, 12 + apart)];
    }
    EXPECT_GT(chi_square_uniform(both).p_value, sidak(8)) << apart;
  }
}

TYPED_TEST(CrossingTest, EveryWordOfTheRayCounts) {
  const auto ray = this->ray({0.1, 0.2, 0.3}, {0.6, 0.0, 0.8});
  const std::uint32_t bits = crossing_bits(ray, 3);
  EXPECT_EQ(crossing_bits(ray, 3), bits);
  EXPECT_NE(crossing_bits(ray, 4), bits);
  for (int axis = 0; axis < 3; ++axis) {
    auto other = ray;
    other.origin[axis] = -other.origin[axis];
    EXPECT_NE(crossing_bits(other, 3), bits) << axis;
    other = ray;
    other.direction[axis] = other.direction[axis] + typename TypeParam::Unit(0.125);
    EXPECT_NE(crossing_bits(other, 3), bits) << axis;
  }
  auto shorter = ray;  // the same crossing, whatever is behind it
  shorter.t_max = typename TypeParam::Length(1);
  EXPECT_EQ(crossing_bits(shorter, 3), bits);
}

// The same bits on every machine.
TEST(CrossingBits, AreWhatTheyWere) {
  const Ray<FixedNumbers> ray{from_host<FixedLength>(glm::dvec3(0.1, 0.2, -0.3)),
                              from_host<FixedUnit>(glm::dvec3(0.6, 0.0, -0.8)), far_away<FixedNumbers>()};
  EXPECT_EQ(crossing_bits(ray, 0), 2577116368U);
  EXPECT_EQ(crossing_bits(ray, 123456), 3046436072U);
}

}  // namespace
}  // namespace vitrine
