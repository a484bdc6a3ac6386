#include "geometry/bvh_build.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

bool contains(const Bounds& outer, const Bounds& inner) {
  return glm::all(glm::lessThanEqual(outer.low, inner.low)) &&
         glm::all(glm::greaterThanEqual(outer.high, inner.high));
}

Bounds around(const glm::dvec3& center, const glm::dvec3& half_extent) {
  return {center - half_extent, center + half_extent};
}

class TreeCheck {
 public:
  TreeCheck(const BvhTree& tree, std::span<const Bounds> primitives)
      : tree_(tree), primitives_(primitives), seen_(primitives.size(), 0) {
    EXPECT_EQ(tree.order.size(), primitives.size());
    visit(0, 0);
    EXPECT_EQ(nodes_, tree.nodes.size());
    EXPECT_TRUE(std::ranges::all_of(seen_, [](int count) { return count == 1; })) << "each primitive once";
  }

  int deepest = 0;
  std::uint32_t largest_leaf = 0;

 private:
  void visit(std::uint32_t index, int depth) {
    ASSERT_LT(index, tree_.nodes.size());
    ASSERT_LE(depth, kBvhMaxDepth);
    deepest = std::max(deepest, depth);
    ++nodes_;
    const BvhTree::Node& node = tree_.nodes[index];
    if (node.count > 0) {
      largest_leaf = std::max<std::uint32_t>(largest_leaf, node.count);
      ASSERT_LE(node.first + node.count, tree_.order.size());
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const std::uint32_t primitive = tree_.order[i];
        ++seen_[primitive];
        EXPECT_TRUE(contains(node.bounds, primitives_[primitive]));
      }
      return;
    }
    EXPECT_LT(node.axis, 3);
    for (const std::uint32_t child : {node.first, node.first + 1}) {
      ASSERT_GT(child, index);
      EXPECT_TRUE(contains(node.bounds, tree_.nodes[child].bounds));
      visit(child, depth + 1);
    }
  }

  const BvhTree& tree_;
  std::span<const Bounds> primitives_;
  std::vector<int> seen_;
  std::size_t nodes_ = 0;
};

TEST(BvhBuildTest, OfNothingIsEmpty) {
  const BvhTree tree = build_bvh({});
  EXPECT_TRUE(tree.nodes.empty());
  EXPECT_TRUE(tree.order.empty());
}

TEST(BvhBuildTest, RandomBoxes) {
  RandomInputs random(1);
  for (const std::size_t count : {1U, 2U, 3U, 8U, 9U, 100U, 20000U}) {
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < count; ++i) {
      boxes.push_back(around(random.in_cube(), glm::abs(random.in_cube(random.log_uniform(1e-6, 0.3)))));
    }
    const BvhTree tree = build_bvh(boxes);
    const TreeCheck check(tree, boxes);
    EXPECT_LE(check.largest_leaf, 8U);
    EXPECT_LE(check.deepest, count == 1 ? 0 : 3 * std::log2(static_cast<double>(count)));
  }
}

TEST(BvhBuildTest, WithoutAnySplit) {
  std::vector<Bounds> same(5000, around(glm::dvec3(0.25), glm::dvec3(0.125)));
  const TreeCheck check_same(build_bvh(same), same);
  EXPECT_LE(check_same.largest_leaf, 8U);
  EXPECT_LE(check_same.deepest, 13);

  std::vector<Bounds> nested;
  for (int i = 1; i <= 5000; ++i) nested.push_back(around(glm::dvec3(0.0), glm::dvec3(i / 5000.0)));
  const TreeCheck check_nested(build_bvh(nested), nested);
  EXPECT_LE(check_nested.largest_leaf, 8U);

  const std::vector<Bounds> points(1000, around(glm::dvec3(0.5), glm::dvec3(0.0)));
  const TreeCheck check_points(build_bvh(points), points);
}

// Each split of equal bins takes off but a few: the depth must still end.
TEST(BvhBuildTest, ExponentiallySpaced) {
  for (const double base : {0.5, 0.06, 0.9}) {
    for (const bool diagonal : {false, true}) {
      std::vector<Bounds> boxes;
      for (int i = 0; i < 1000; ++i) {
        const double x = std::pow(base, i);
        boxes.push_back(
            around(diagonal ? glm::dvec3(x, -x, x) : glm::dvec3(x, 0.0, 0.0), glm::dvec3(x * 0.01)));
      }
      const TreeCheck check(build_bvh(boxes), boxes);
      EXPECT_LE(check.deepest, kBvhMaxDepth);
    }
  }
  // Many in each octave.
  RandomInputs random(2);
  std::vector<Bounds> octaves;
  for (int i = 0; i < 50000; ++i) {
    octaves.push_back(around(random.direction() * random.log_uniform(1e-30, 1.0), glm::dvec3(0.0)));
  }
  const TreeCheck check(build_bvh(octaves), octaves);
  EXPECT_LE(check.largest_leaf, 8U);
}

TEST(BvhBuildTest, FlatAndThin) {
  RandomInputs random(3);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Bounds> plane;
    std::vector<Bounds> line;
    for (int i = 0; i < 2000; ++i) {
      glm::dvec3 p = random.in_cube();
      p[axis] = 0.5;
      plane.push_back(around(p, glm::dvec3(0.0)));
      glm::dvec3 q(0.0);
      q[axis] = random.uniform(-1.0, 1.0);
      line.push_back(around(q, glm::dvec3(0.0)));
    }
    const TreeCheck check_plane(build_bvh(plane), plane);
    const TreeCheck check_line(build_bvh(line), line);
    EXPECT_LE(check_plane.largest_leaf, 8U);
    EXPECT_LE(check_line.largest_leaf, 8U);
  }
}

TEST(BvhBuildTest, OneHugeAmongMany) {
  RandomInputs random(4);
  std::vector<Bounds> boxes{around(glm::dvec3(0.0), glm::dvec3(1.0))};
  for (int i = 0; i < 3000; ++i) boxes.push_back(around(random.in_cube(), glm::dvec3(1e-3)));
  const TreeCheck check(build_bvh(boxes), boxes);
  EXPECT_LE(check.deepest, 30);
}

TEST(BvhBuildTest, SplitsWhereTheSurfaceAreaSays) {
  std::vector<Bounds> clusters;  // two far apart, unequal
  RandomInputs random(5);
  for (int i = 0; i < 100; ++i)
    clusters.push_back(around(glm::dvec3(-0.9, 0, 0) + random.in_cube(0.05), glm::dvec3(0.01)));
  for (int i = 0; i < 10; ++i)
    clusters.push_back(around(glm::dvec3(0.9, 0, 0) + random.in_cube(0.05), glm::dvec3(0.01)));
  const BvhTree tree = build_bvh(clusters);
  const TreeCheck check(tree, clusters);
  const BvhTree::Node& root = tree.nodes[0];
  EXPECT_EQ(root.axis, 0);
  EXPECT_LT(tree.nodes[root.first].bounds.high.x, -0.8);
  EXPECT_GT(tree.nodes[root.first + 1].bounds.low.x, 0.8);
}

TEST(BoundsTest, HalfArea) {
  EXPECT_EQ(Bounds{}.half_area(), 0.0);
  EXPECT_DOUBLE_EQ(around(glm::dvec3(3.0), glm::dvec3(0.5, 1.0, 1.5)).half_area(), 1 * 2 + 2 * 3 + 3 * 1);
}

}  // namespace
}  // namespace vitrine
