// Building a bounding volume hierarchy: top-down, binned surface area heuristic (Wald 2007), on the host's
// arithmetic. The tree is flat: children stand side by side, and a leaf is a range of `order`.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bounds.h"

namespace vitrine {

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
