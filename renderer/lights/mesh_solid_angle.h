// The triangles of a small light as a receiver sees them: sampled uniformly by their solid angle as a whole,
// so that each direction to the light is as likely and the cosine at the light does not matter. Triangles
// that turn their back are left out. Lecture: "Direct Illumination - One Light", "slightly better techniques
// exist".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "lights/emissive_triangle.h"
#include "sampling/number_range.h"
#include "sampling/spherical_triangle.h"

namespace vitrine {

template <class N>
class MeshSolidAngle {
  using Unit = typename N::Unit;
  using Length = typename N::Length;
  using Density = typename N::Density;

 public:
  static constexpr std::size_t kMostTriangles = 8;
  /// In steradians. A smaller light is as well sampled by its area, and a Unit would lose digits.
  static constexpr double kLeast = 0x1p-12;

  /// `triangles`: at most kMostTriangles.
  MeshSolidAngle(std::span<const EmissiveTriangle<N>> triangles, bool two_sided, const Vec3<Length>& p)
      : count_(triangles.size()) {
    bool sound = true;
    for (std::size_t i = 0; i < count_; ++i) {
      const EmissiveTriangle<N>& t = triangles[i];
      Seen& seen = seen_[i];
      const Vec3<Length> a = t.corner - p;
      const Vec3<Length> b = a + t.edge_u;
      const Vec3<Length> c = a + t.edge_v;
      const Vec3<Unit> to_a = normalize(a);
      if (!two_sided && !(dot(to_a, t.normal) < 0)) continue;
      seen.distances = {length(a), length(b), length(c)};
      seen.triangle = SphericalTriangle<N>(to_a, normalize(b), normalize(c));
      seen.solid_angle = seen.triangle.solid_angle();
      sound = sound && seen.triangle.is_sound();
    }
    for (std::size_t i = count_; i-- > 0;)
      seen_[i].from_here_on = seen_[i].solid_angle + seen_[i + 1].from_here_on;
    const Density whole = seen_[0].from_here_on;
    is_sound_ = sound && !(whole > 0 && whole < Density(kLeast));
  }

  /// Whether the arithmetic holds: the light is neither too small nor too close.
  [[nodiscard]] bool is_sound() const { return is_sound_; }
  [[nodiscard]] bool is_seen() const { return seen_[0].from_here_on > 0; }

  struct Point {
    std::uint32_t i;  ///< which of the triangles
    Vec2<Unit> barycentric;
    Density pdf_w;
  };
  /// For a light that is seen.
  [[nodiscard]] Point sample(std::uint32_t bits, Unit u, Unit v) const {
    NumberRange<N> range;
    std::size_t i = 0;
    while (!choose(i, range, [&](std::uint64_t share) { return range.is_first(bits, share); })) ++i;
    const Seen& seen = seen_[i];
    const Vec3<Unit> w = seen.triangle.sample(u, v);
    const Vec3<Unit> scaled = w * seen.relative_nearness();
    const Unit sum = scaled.x + scaled.y + scaled.z;
    return {static_cast<std::uint32_t>(i), {scaled.y / sum, scaled.z / sum}, range.prob() / seen.solid_angle};
  }
  /// The density of sample() for every direction to its i-th triangle.
  [[nodiscard]] Density pdf_w(std::uint32_t i) const {
    if (!(seen_[i].solid_angle > 0)) return Density(0);
    NumberRange<N> range;
    for (std::size_t k = 0; k <= i; ++k) choose(k, range, [&](std::uint64_t) { return k == i; });
    return range.prob() / seen_[i].solid_angle;
  }

 private:
  struct Seen {
    Vec3<Length> distances{};  // of the corners
    SphericalTriangle<N> triangle;
    Density solid_angle = Density(0);  // 0: not seen
    Density from_here_on = Density(0);

    // The nearest corner's distance over each.
    [[nodiscard]] Vec3<Unit> relative_nearness() const {
      const Length nearest = std::min({distances.x, distances.y, distances.z});
      const auto over = [&](Length d) { return Unit((nearest * nearest) / (nearest * d)); };
      return {over(distances.x), over(distances.y), over(distances.z)};
    }
  };

  // Takes triangle `i` or leaves it to the later ones, as `is_first` says of the share of numbers that take
  // it.
  template <class IsFirst>
  bool choose(std::size_t i, NumberRange<N>& range, const IsFirst& is_first) const {
    const std::uint64_t share =
        range.share_of_first(seen_[i].solid_angle, seen_[i + 1].from_here_on, 1, count_ - i);
    const bool first = is_first(share);
    range.keep(first, share);
    return first;
  }

  std::size_t count_;
  std::array<Seen, kMostTriangles + 1> seen_;  // and a last one that fills nothing
  bool is_sound_ = false;
};

}  // namespace vitrine
