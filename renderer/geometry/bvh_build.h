// Building a bounding volume hierarchy: top-down, binned surface area heuristic (Wald 2007), on the host's
// arithmetic. The tree is flat: children stand side by side, and a leaf is a range of `order`.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace vitrine {

struct Bounds {
  glm::dvec3 low{1e300};
  glm::dvec3 high{-1e300};

  void grow(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void grow(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  /// Half the surface area; 0 for empty bounds.
  [[nodiscard]] double half_area() const {
    const glm::dvec3 d = glm::max(high - low, glm::dvec3(0.0));
    return d.x * d.y + d.y * d.z + d.z * d.x;
  }
};

struct BvhTree {
  struct Node {
    Bounds bounds;
    std::uint32_t first = 0;  ///< leaf: index into order; inner node: its left child, the right one follows
    std::uint16_t count = 0;  ///< primitives of a leaf; 0: inner node
    std::uint16_t axis = 0;   ///< inner node: along which the left child comes first
  };
  std::vector<Node> nodes;  ///< nodes[0] is the root; empty when there are no primitives
  std::vector<std::uint32_t> order;
};

/// No path from the root is longer than this: a traversal stack of that many entries suffices.
inline constexpr int kBvhMaxDepth = 64;

BvhTree build_bvh(std::span<const Bounds> primitives);

}  // namespace vitrine
