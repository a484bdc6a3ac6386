// The bounding volume hierarchy in a number system, and its traversal: closest hit and any hit, over
// triangles by index. Boxes are padded, so that no rounding of a slab test can lose a triangle that the
// watertight test would hit. The caller may say which hits count: one that does not is as if the triangle
// were not there.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bvh_build.h"
#include "geometry/ray.h"
#include "geometry/watertight_triangle.h"
#include "numeric/host_conversion.h"

namespace vitrine {

/// Which hits count where nobody says otherwise.
struct EveryHit {
  template <class N>
  constexpr bool operator()(const Ray<N>& /*ray*/, const Hit<N>& /*hit*/) const {
    return true;
  }
};

template <class N>
class Bvh {
  using Length = typename N::Length;
  using Unit = typename N::Unit;

 public:
  Bvh() = default;
  /// Triangles are index triples into `positions`.
  Bvh(std::vector<Vec3<Length>> positions, std::vector<glm::uvec3> triangles)
      : positions_(std::move(positions)), triangles_(std::move(triangles)) {
    std::vector<Bounds> bounds(triangles_.size());
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      for (int corner = 0; corner < 3; ++corner) bounds[i].grow(to_host(positions_[triangles_[i][corner]]));
    }
    BvhTree tree = build_bvh(bounds);
    nodes_.reserve(tree.nodes.size());
    // A slab's distance is off by at most 2^-21 (float) of a box at most 2 sqrt(3) wide.
    constexpr double kPadding = 0x1p-18;
    for (const BvhTree::Node& node : tree.nodes) {
      nodes_.push_back({from_host<Length>(node.bounds.low - kPadding),
                        from_host<Length>(node.bounds.high + kPadding), node.first, node.count, node.axis});
    }
    order_ = std::move(tree.order);
  }

  [[nodiscard]] std::span<const glm::uvec3> triangles() const { return triangles_; }
  [[nodiscard]] std::span<const Vec3<Length>> positions() const { return positions_; }

  /// hits[i] for rays[i]: the nearest triangle before t_max, either side, whose hit `counts(ray, hit)`. In
  /// which order hits are asked for, and which of those that lie behind the nearest, is not defined.
  template <class Counts = EveryHit>
  void closest(std::span<const Ray<N>> rays, std::span<Hit<N>> hits, const Counts& counts = {}) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      hits[i] = {.t = rays[i].t_max};
      traverse<false>(rays[i], hits[i], counts);
    }
  }
  /// occluded[i] = 1 if anything that counts is in the way of rays[i] before t_max.
  template <class Counts = EveryHit>
  void occluded(std::span<const Ray<N>> rays, std::span<std::uint8_t> occluded,
                const Counts& counts = {}) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      Hit<N> hit{.t = rays[i].t_max};
      traverse<true>(rays[i], hit, counts);
      occluded[i] = hit ? 1 : 0;
    }
  }

 private:
  struct Node {
    Vec3<Length> low;
    Vec3<Length> high;
    std::uint32_t first;
    std::uint16_t count;
    std::uint16_t axis;
  };

  // A ray prepared for boxes.
  struct SlabRay {
    Vec3<Length> origin;
    typename N::Inverse inverse[3];
    bool negative[3];

    explicit SlabRay(const Ray<N>& ray)
        : origin(ray.origin),
          inverse{N::inverse(ray.direction.x), N::inverse(ray.direction.y), N::inverse(ray.direction.z)},
          negative{ray.direction.x < 0, ray.direction.y < 0, ray.direction.z < 0} {}

    [[nodiscard]] bool meets(const Node& node, Length t_max) const {
      Length near = Length(0);
      Length far = t_max;
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3<Length>& entry = negative[axis] ? node.high : node.low;
        const Vec3<Length>& exit = negative[axis] ? node.low : node.high;
        const Length in = (entry[axis] - origin[axis]) * inverse[axis];
        const Length out = (exit[axis] - origin[axis]) * inverse[axis];
        if (near < in) near = in;
        if (out < far) far = out;
      }
      return !(far < near);
    }
  };

  template <bool kAny, class Counts>
  void traverse(const Ray<N>& ray, Hit<N>& hit, const Counts& counts) const {
    if (nodes_.empty()) return;
    const SlabRay slabs(ray);
    const ShearedRay<N> sheared(ray);
    std::array<std::uint32_t, kBvhMaxDepth + 1> stack;  // NOLINT: filled before it is read
    std::size_t stacked = 0;
    std::uint32_t index = 0;
    while (true) {
      const Node& node = nodes_[index];
      if (slabs.meets(node, hit.t)) {
        if (node.count == 0) {  // the nearer child first
          const std::uint32_t right_first = slabs.negative[node.axis] ? 1 : 0;
          stack[stacked++] = node.first + 1 - right_first;
          index = node.first + right_first;
          continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
          const glm::uvec3& corners = triangles_[order_[i]];
          const Hit<N> before = hit;
          if (!sheared.intersect(positions_[corners.x], positions_[corners.y], positions_[corners.z], hit)) {
            continue;
          }
          hit.triangle = order_[i];
          if (!counts(ray, hit)) {
            hit = before;
          } else if constexpr (kAny) {
            return;
          }
        }
      }
      if (stacked == 0) return;
      index = stack[--stacked];
    }
  }

  std::vector<Vec3<Length>> positions_;
  std::vector<glm::uvec3> triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace vitrine
