#include "lights/light_tree_build.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <optional>

namespace vitrine {
namespace {

constexpr double kPi = std::numbers::pi;

glm::dvec3 center_of(const LightEmission& light) { return 0.5 * (light.bounds.low + light.bounds.high); }

LightEmission united(const LightEmission& a, const LightEmission& b) {
  LightEmission both{.intensity = a.intensity + b.intensity,
                     .bounds = a.bounds,
                     .cos_spread = std::min(a.cos_spread, b.cos_spread),
                     .two_sided = a.two_sided || b.two_sided};
  both.bounds.grow(b.bounds);
  if (!both.is_far()) {
    const glm::dvec3 center = center_of(both);
    const auto reach = [&](const LightEmission& x) { return glm::length(center_of(x) - center) + x.radius; };
    const double half_diagonal = 0.5 * glm::length(both.bounds.high - both.bounds.low);
    both.radius = std::min(half_diagonal, std::max(reach(a), reach(b)));
  }
  Cone other = b.cone;
  if (both.two_sided && glm::dot(a.cone.axis, other.axis) < 0.0) other.axis = -other.axis;
  both.cone = united(a.cone, other);
  return both;
}

// How much a receiver somewhere is bothered with a cluster.
double cost(const LightEmission& light) {
  const double half = std::acos(std::clamp(light.cone.cos_half, -1.0, 1.0));
  const double rim = std::min(kPi, half + std::acos(light.cos_spread));
  const double omega =
      2.0 * kPi * (1.0 - std::cos(half)) + kPi / 2.0 *
                                               (2.0 * rim * std::sin(half) - std::cos(half - 2.0 * rim) -
                                                2.0 * half * std::sin(half) + std::cos(half));
  const glm::dvec3 diagonal = light.bounds.high - light.bounds.low;
  // Lights on one line have no area, and yet it matters how far they are apart.
  const double area = light.bounds.half_area() + 0.01 * glm::dot(diagonal, diagonal);
  return light.intensity * area * (light.two_sided ? std::min(4.0 * kPi, 2.0 * omega) : omega);
}

class Builder {
 public:
  explicit Builder(std::span<const LightEmission> lights) : lights_(lights), order_(lights.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    layout_.trails.resize(lights.size());
  }

  LightTreeLayout build() {
    if (lights_.empty()) return std::move(layout_);
    const auto far = std::stable_partition(order_.begin(), order_.end(),
                                           [&](std::uint32_t i) { return !lights_[i].is_far(); });
    near_ = static_cast<std::size_t>(far - order_.begin());
    layout_.nodes.reserve(2 * lights_.size());
    layout_.nodes.emplace_back();
    add(0, 0, order_.size(), 0, 0);
    return std::move(layout_);
  }

 private:
  // Lays out the lights order_[begin, end) under `node`, to which `trail` leads in `depth` steps.
  void add(std::size_t node, std::size_t begin, std::size_t end, std::uint64_t trail, int depth) {
    const auto count = static_cast<std::uint32_t>(end - begin);
    if (count == 1) {
      layout_.nodes[node] = {lights_[order_[begin]], order_[begin], 1};
      layout_.trails[order_[begin]] = trail;
      return;
    }
    const std::size_t middle = split(begin, end, depth);
    const std::size_t first = layout_.nodes.size();
    layout_.nodes.resize(first + 2);
    add(first, begin, middle, trail, depth + 1);
    add(first + 1, middle, end, trail | (std::uint64_t{1} << depth), depth + 1);
    layout_.nodes[node] = {united(layout_.nodes[first].emission, layout_.nodes[first + 1].emission),
                           static_cast<std::uint32_t>(first), count};
  }

  // Orders [begin, end) into two parts and returns where the second begins.
  std::size_t split(std::size_t begin, std::size_t end, int depth) {
    if (begin < near_ && near_ < end) return near_;
    const std::size_t half = begin + (end - begin) / 2;
    const bool steps_are_short = depth + static_cast<int>(std::bit_width(end - begin)) >= kMaxDepth;
    if (begin >= near_ || steps_are_short) return half;
    Bounds centers;
    for (std::size_t i = begin; i < end; ++i) centers.grow(center_of(lights_[order_[i]]));
    const auto best = best_plane(begin, end, centers);
    if (!best) return half;  // all at one place
    const auto second = std::partition(at(begin), at(end), [&](std::uint32_t i) {
      return bucket(centers, best->axis, center_of(lights_[i])) <= best->last_bucket;
    });
    return static_cast<std::size_t>(second - order_.begin());
  }

  struct Plane {
    int axis;
    std::size_t last_bucket;  // of the first part
  };
  static constexpr std::size_t kBuckets = 12;
  static constexpr int kMaxDepth = 63;

  static std::size_t bucket(const Bounds& centers, int axis, const glm::dvec3& p) {
    const double x = (p[axis] - centers.low[axis]) / (centers.high[axis] - centers.low[axis]);
    return std::min(kBuckets - 1, static_cast<std::size_t>(x * kBuckets));
  }

  [[nodiscard]] std::optional<Plane> best_plane(std::size_t begin, std::size_t end,
                                                const Bounds& centers) const {
    const glm::dvec3 sides = centers.high - centers.low;
    const double longest = std::max({sides.x, sides.y, sides.z});
    std::optional<Plane> best;
    double least = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(sides[axis] > 0.0)) continue;
      std::array<std::optional<LightEmission>, kBuckets> buckets;
      const auto grow = [](std::optional<LightEmission>& sum, const LightEmission& light) {
        sum = sum ? united(*sum, light) : light;
      };
      for (std::size_t i = begin; i < end; ++i) {
        const LightEmission& light = lights_[order_[i]];
        grow(buckets[bucket(centers, axis, center_of(light))], light);
      }
      std::array<double, kBuckets> costs{};  // of a plane after each bucket
      std::optional<LightEmission> below;
      std::optional<LightEmission> above;
      for (std::size_t i = 0; i + 1 < kBuckets; ++i) {
        if (buckets[i]) grow(below, *buckets[i]);
        costs[i] += cost(*below);  // the first bucket is never empty, nor the last
        if (buckets[kBuckets - 1 - i]) grow(above, *buckets[kBuckets - 1 - i]);
        costs[kBuckets - 2 - i] += cost(*above);
      }
      for (std::size_t i = 0; i + 1 < kBuckets; ++i) {
        const double sum = costs[i] * longest / sides[axis];
        if (!best || sum < least) {
          best = {axis, i};
          least = sum;
        }
      }
    }
    return best;
  }

  std::vector<std::uint32_t>::iterator at(std::size_t i) {
    return order_.begin() + static_cast<std::ptrdiff_t>(i);
  }

  std::span<const LightEmission> lights_;
  std::vector<std::uint32_t> order_;  // near lights before far ones
  std::size_t near_ = 0;
  LightTreeLayout layout_;
};

}  // namespace

LightTreeLayout build_light_tree(std::span<const LightEmission> lights) { return Builder(lights).build(); }

}  // namespace vitrine
