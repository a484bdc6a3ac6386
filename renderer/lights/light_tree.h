// One light at random by a tree of lights: at each node the child whose lights may give the receiver more is
// the more probable one. Its importance is about the irradiance that it could give at the best, by a ball
// around its lights and a cone around the directions in which they shine (Conty Estevez and Kulla 2018;
// cosines as in pbrt-v4, LightBounds::Importance):
//
//   importance = intensity cos(max(0, theta_light - theta_cone - theta_ball))
//                          cos(max(0, theta_receiver - theta_ball)) / max(d^2, radius^2)
//
// It is 0 only for a child of which no light can reach the receiver.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lights/light_tree_build.h"
#include "lights/receiver.h"
#include "numeric/host_conversion.h"
#include "sampling/number_range.h"

namespace vitrine {

template <class N>
class LightTree {
  using Unit = typename N::Unit;
  using Length = typename N::Length;
  using Area = typename N::Area;
  using Density = typename N::Density;

 public:
  LightTree() = default;
  explicit LightTree(std::span<const LightEmission> lights) {
    LightTreeLayout layout = build_light_tree(lights);
    trails_ = std::move(layout.trails);
    nodes_.reserve(layout.nodes.size());
    for (const LightCluster& cluster : layout.nodes) nodes_.push_back(node_of(cluster));
  }

  /// Nothing where all that is left cannot reach the receiver.
  [[nodiscard]] std::optional<SelectedLight<N>> select(const Receiver<N>& receiver,
                                                       std::uint32_t bits) const {
    NumberRange<N> range;
    const Node* node = nodes_.data();
    while (node->count > 1) {
      const auto share = share_of_first(receiver, *node, range);
      if (!share) return std::nullopt;
      const bool first = range.is_first(bits, *share);
      range.keep(first, *share);
      node = &nodes_[node->first + (first ? 0 : 1)];
    }
    return SelectedLight<N>{node->first, range.prob()};
  }

  /// The probability with which select() gives `light`.
  [[nodiscard]] Density prob(const Receiver<N>& receiver, std::uint32_t light) const {
    NumberRange<N> range;
    const Node* node = nodes_.data();
    for (std::uint64_t trail = trails_[light]; node->count > 1; trail >>= 1) {
      const auto share = share_of_first(receiver, *node, range);
      if (!share) return Density(0);
      const bool first = (trail & 1) == 0;
      range.keep(first, *share);
      if (range.size() == 0) return Density(0);
      node = &nodes_[node->first + (first ? 0 : 1)];
    }
    return range.prob();
  }

 private:
  struct Node {
    Vec3<Length> center;
    Area radius_squared;
    Density intensity;
    Vec3<Unit> axis;  // of the cone
    Unit cos_cone;
    Unit sin_cone;
    Unit cos_spread;
    std::uint32_t first;  // light or child
    std::uint32_t count;  // of lights
    bool far;
    bool two_sided;
    bool everywhere;  // the cone is all directions
  };

  /// An angle between 0 and a half turn.
  struct Angle {
    Unit cos;
    Unit sin;

    static Angle of_cosine(Unit cosine) { return {cosine, sqrt((1 - cosine) * (1 + cosine))}; }
    /// Their difference, or 0.
    friend Angle operator-(const Angle& a, const Angle& b) {
      if (!(a.cos < b.cos)) return {Unit(1), Unit(0)};
      return {a.cos * b.cos + a.sin * b.sin, a.sin * b.cos - a.cos * b.sin};
    }
  };

  // What rounding may take from a cosine or a radius: a light is not given up before it is so far out of
  // reach.
  static constexpr double kSlack = 0x1p-9;
  static constexpr double kRadiusSlack = 0x1p-18;

  static Node node_of(const LightCluster& cluster) {
    const LightEmission& light = cluster.emission;
    const glm::dvec3 center = light.is_far() ? glm::dvec3(0.0) : 0.5 * (light.bounds.low + light.bounds.high);
    const double radius = light.radius * (1.0 + kRadiusSlack) + kRadiusSlack;
    const double cos_cone = std::clamp(light.cone.cos_half, -1.0, 1.0);
    return {.center = from_host<Length>(center),
            .radius_squared = from_host<Area>(radius * radius),
            .intensity = from_host<Density>(light.intensity),
            .axis = from_host<Unit>(light.cone.axis),
            .cos_cone = from_host<Unit>(cos_cone),
            .sin_cone = from_host<Unit>(std::sqrt(1.0 - cos_cone * cos_cone)),
            .cos_spread = from_host<Unit>(light.cos_spread),
            .first = cluster.first,
            .count = cluster.count,
            .far = light.is_far(),
            .two_sided = light.two_sided,
            .everywhere = cos_cone <= -1.0};
  }

  // How many of the range's numbers lead to the first child; nothing if neither can matter.
  std::optional<std::uint64_t> share_of_first(const Receiver<N>& receiver, const Node& node,
                                              const NumberRange<N>& range) const {
    const Node& first = nodes_[node.first];
    const Node& second = nodes_[node.first + 1];
    const Density first_importance = importance(first, receiver);
    const Density second_importance = importance(second, receiver);
    if (!(first_importance > 0) && !(second_importance > 0)) return std::nullopt;
    // Near and far lights are hard to compare: a roof keeps the sky out, and a hall's lamps are all around.
    // So neither gets less than an eighth. Within them, every light keeps a number.
    const std::uint64_t least = first.far != second.far ? range.size() / 8 : 0;
    return range.share_of_first(first_importance, second_importance,
                                std::max<std::uint64_t>(least, first.count),
                                std::max<std::uint64_t>(least, second.count));
  }

  [[nodiscard]] static Density importance(const Node& node, const Receiver<N>& receiver) {
    if (node.far) {
      return node.intensity * Density(node.everywhere
                                          ? Unit(1)
                                          : cosine_at(receiver, node.axis, {node.cos_cone, node.sin_cone}));
    }
    const Vec3<Length> way = node.center - receiver.position;
    const Area distance_squared = dot(way, way);
    if (!(distance_squared > node.radius_squared)) return node.intensity / Density(node.radius_squared);
    const Vec3<Unit> wi = normalize(way);
    const Unit sin_squared = Unit(node.radius_squared / distance_squared);
    const Angle ball{sqrt(1 - sin_squared), sqrt(sin_squared)};
    const Unit received = cosine_at(receiver, wi, ball);
    if (!(received > 0)) return Density(0);
    const Unit sent = cosine_from(node, wi, ball);
    if (!(sent > 0)) return Density(0);
    return node.intensity * Density(received * sent) / Density(distance_squared);
  }

  // The largest cosine between the receiver's normal and a direction within the angle `around` of `wi`; 0 if
  // none is above the horizon.
  static Unit cosine_at(const Receiver<N>& receiver, const Vec3<Unit>& wi, const Angle& around) {
    if (receiver.both_sides) return Unit(1);
    return usable((Angle::of_cosine(dot(receiver.normal, wi)) - around).cos, Unit(0));
  }
  // The largest cosine between a direction of the node's cone and one to the receiver; 0 if that is beyond
  // the spread.
  static Unit cosine_from(const Node& node, const Vec3<Unit>& wi, const Angle& ball) {
    if (node.everywhere) return Unit(1);
    Unit cosine = -dot(node.axis, wi);
    if (node.two_sided) cosine = abs(cosine);
    return usable((Angle::of_cosine(cosine) - Angle{node.cos_cone, node.sin_cone} - ball).cos,
                  node.cos_spread);
  }
  static Unit usable(Unit cosine, Unit least) {
    if (cosine < least - Unit(kSlack)) return Unit(0);
    return std::max(cosine, Unit(kSlack));
  }

  std::vector<Node> nodes_;
  std::vector<std::uint64_t> trails_;
};

}  // namespace vitrine
