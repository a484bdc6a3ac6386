// A light in the shape of triangles, sampled uniformly by area: pdf_a = 1 / area of the whole mesh, whichever
// triangle. Lecture: "Direct Illumination - One Light", uniform sampling of the light's area.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lights/light_sample.h"
#include "sampling/discrete_distribution.h"
#include "sampling/warps.h"

namespace vitrine {

template <class N>
struct EmissiveTriangle {
  Vec3<typename N::Length> corner;
  Vec3<typename N::Length> edge_u;
  Vec3<typename N::Length> edge_v;
  Vec3<typename N::Unit> normal;
  std::uint32_t triangle;  ///< of the World
  double area;             ///< for building only
};

template <class N>
class MeshLight {
  using Unit = typename N::Unit;
  using Length = typename N::Length;
  using Density = typename N::Density;

 public:
  MeshLight(std::vector<EmissiveTriangle<N>> triangles, bool two_sided)
      : triangles_(std::move(triangles)), two_sided_(two_sided) {
    std::vector<double> areas;
    for (const auto& t : triangles_) areas.push_back(t.area);
    chosen_ = DiscreteDistribution<N>(areas);
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      pdf_a_.push_back(chosen_.prob(i) / from_host<Density>(triangles_[i].area));
    }
  }

  [[nodiscard]] std::span<const EmissiveTriangle<N>> triangles() const { return triangles_; }

  /// A point of the light as seen from `p`; nothing when its back is turned.
  [[nodiscard]] std::optional<LightSample<N>> sample(const Vec3<Length>& p, std::uint32_t bits,
                                                     std::uint32_t alias_bits, Unit u, Unit v) const {
    const std::uint32_t i = chosen_.sample(bits, alias_bits);
    const EmissiveTriangle<N>& t = triangles_[i];
    const Vec2<Unit> b = sample_triangle<N>(u, v);
    const Vec3<Length> point = t.corner + t.edge_u * b.x + t.edge_v * b.y;
    const Vec3<Length> to_light = point - p;
    const Length distance = length(to_light);
    if (!(distance > 0)) return std::nullopt;
    const Vec3<Unit> wi = normalize(to_light);
    const Density pdf_w = this->pdf_w(i, wi, distance);
    if (!(pdf_w > 0)) return std::nullopt;
    const Vec3<Length> off = t.normal * ray_offset<N>();
    return LightSample<N>{.wi = wi,
                          .end = dot(wi, t.normal) < 0 ? point + off : point - off,
                          .radiance = {},
                          .pdf_w = pdf_w,
                          .triangle = t.triangle,
                          .barycentric = b};
  }

  /// The density with which sample() finds the point of its i-th triangle that a ray along `wi` meets after
  /// `distance`: pdf_a d^2 / cos; 0 from behind.
  [[nodiscard]] Density pdf_w(std::uint32_t i, const Vec3<Unit>& wi, Length distance) const {
    Unit cosine = -dot(wi, triangles_[i].normal);
    if (two_sided_) cosine = abs(cosine);
    if (!(cosine > 0)) return Density(0);
    return pdf_a_[i] * Density(distance * distance) / Density(cosine);
  }

 private:
  std::vector<EmissiveTriangle<N>> triangles_;
  std::vector<Density> pdf_a_;
  DiscreteDistribution<N> chosen_;
  bool two_sided_;
};

}  // namespace vitrine
