#include "geometry/bvh_build.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace vitrine {
namespace {

constexpr int kBins = 16;
constexpr std::uint32_t kMaxLeaf = 8;
constexpr double kTraversalCost = 1.0;  // of a node, in triangle tests
constexpr int kBalancedBelow = 40;  // deeper, ranges are halved: 2^24 primitives then end within kBvhMaxDepth

struct Split {
  double cost;
  int axis = -1;
  int bin = 0;  // the first bin of the right side
};

class Builder {
 public:
  explicit Builder(std::span<const Bounds> primitives) : primitives_(primitives) {
    tree_.order.resize(primitives.size());
    std::iota(tree_.order.begin(), tree_.order.end(), 0U);
    if (primitives.empty()) return;
    tree_.nodes.reserve(2 * primitives.size());
    tree_.nodes.emplace_back();
    subdivide(0, 0, static_cast<std::uint32_t>(primitives.size()), 0);
  }
  BvhTree take() { return std::move(tree_); }

 private:
  [[nodiscard]] glm::dvec3 center(std::uint32_t primitive) const {
    return 0.5 * (primitives_[primitive].low + primitives_[primitive].high);
  }
  static int bin_of(double x, double low, double extent) {
    return std::min(kBins - 1, static_cast<int>((x - low) / extent * kBins));
  }

  void subdivide(std::uint32_t node, std::uint32_t begin, std::uint32_t end, int depth) {
    Bounds bounds;
    Bounds centers;
    for (std::uint32_t i = begin; i < end; ++i) {
      bounds.grow(primitives_[tree_.order[i]]);
      centers.grow(center(tree_.order[i]));
    }
    tree_.nodes[node].bounds = bounds;
    const std::uint32_t count = end - begin;
    const Split split = best_split(begin, end, bounds, centers);
    if (count == 1 || (count <= kMaxLeaf && split.cost >= count) || depth == kBvhMaxDepth) {
      tree_.nodes[node].first = begin;
      tree_.nodes[node].count = static_cast<std::uint16_t>(count);
      return;
    }
    int axis = split.axis;
    std::uint32_t middle = begin + count / 2;
    const auto at = [&](std::uint32_t i) { return tree_.order.begin() + static_cast<std::ptrdiff_t>(i); };
    if (axis >= 0 && depth < kBalancedBelow) {
      const double low = centers.low[axis];
      const double extent = centers.high[axis] - low;
      const auto right = std::partition(at(begin), at(end), [&](std::uint32_t p) {
        return bin_of(center(p)[axis], low, extent) < split.bin;
      });
      middle = static_cast<std::uint32_t>(right - tree_.order.begin());
    } else {
      const glm::dvec3 extent = centers.high - centers.low;
      axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
      std::nth_element(at(begin), at(middle), at(end),
                       [&](std::uint32_t a, std::uint32_t b) { return center(a)[axis] < center(b)[axis]; });
    }
    const auto left = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes.resize(tree_.nodes.size() + 2);
    tree_.nodes[node].first = left;
    tree_.nodes[node].axis = static_cast<std::uint16_t>(axis);
    subdivide(left, begin, middle, depth + 1);
    subdivide(left + 1, middle, end, depth + 1);
  }

  // The cheapest split by the surface area heuristic; cost is in triangle tests, axis -1: no split separates
  // centres.
  [[nodiscard]] Split best_split(std::uint32_t begin, std::uint32_t end, const Bounds& bounds,
                                 const Bounds& centers) const {
    Split best{.cost = 1e300};
    for (int axis = 0; axis < 3; ++axis) {
      const double low = centers.low[axis];
      const double extent = centers.high[axis] - low;
      if (!(extent > 0.0)) continue;
      std::array<Bounds, kBins> bin_bounds;
      std::array<std::uint32_t, kBins> bin_count{};
      for (std::uint32_t i = begin; i < end; ++i) {
        const auto bin = static_cast<std::size_t>(bin_of(center(tree_.order[i])[axis], low, extent));
        bin_bounds[bin].grow(primitives_[tree_.order[i]]);
        ++bin_count[bin];
      }
      std::array<double, kBins> right_cost{};  // of bins i.. as one child
      Bounds right;
      std::uint32_t right_count = 0;
      for (std::size_t i = kBins - 1; i > 0; --i) {
        right.grow(bin_bounds[i]);
        right_count += bin_count[i];
        right_cost[i] = right_count * right.half_area();
      }
      Bounds left;
      std::uint32_t left_count = 0;
      for (std::size_t i = 1; i < kBins; ++i) {
        left.grow(bin_bounds[i - 1]);
        left_count += bin_count[i - 1];
        if (left_count == 0 || left_count == end - begin) continue;
        const double area = bounds.half_area();
        const double children = left_count * left.half_area() + right_cost[i];
        const double cost = kTraversalCost + (area > 0.0 ? children / area : end - begin);
        if (cost < best.cost) best = {.cost = cost, .axis = axis, .bin = static_cast<int>(i)};
      }
    }
    return best;
  }

  std::span<const Bounds> primitives_;
  BvhTree tree_;
};

}  // namespace

BvhTree build_bvh(std::span<const Bounds> primitives) { return Builder(primitives).take(); }

}  // namespace vitrine
