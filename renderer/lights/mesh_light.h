// A light in the shape of triangles. Lecture: "Direct Illumination - One Light". Its points are sampled
// uniformly by area, pdf_a = 1 / area of the whole mesh, whichever triangle; or, where it is of few
// triangles, uniformly by the solid angle that the receiver sees (mesh_solid_angle.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lights/emissive_triangle.h"
#include "lights/light_points.h"
#include "lights/light_sample.h"
#include "lights/mesh_solid_angle.h"
#include "sampling/discrete_distribution.h"
#include "sampling/warps.h"

namespace vitrine {

template <class N>
class MeshLight {
  using Unit = typename N::Unit;
  using Length = typename N::Length;
  using Area = typename N::Area;
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
    // All of the light is within `size` of its first corner, and no solid angle is over area / distance^2.
    double area = 0.0;
    double size = 0.0;
    for (const auto& t : triangles_) {
      area += t.area;
      const glm::dvec3 corner = to_host(t.corner) - to_host(triangles_.front().corner);
      size = std::max({size, glm::length(corner), glm::length(corner + to_host(t.edge_u)),
                       glm::length(corner + to_host(t.edge_v))});
    }
    const double reach = std::sqrt(area / MeshSolidAngle<N>::kLeast) + size;
    solid_angle_reach_squared_ = from_host<Area>(reach * reach);
  }

  [[nodiscard]] std::span<const EmissiveTriangle<N>> triangles() const { return triangles_; }
  [[nodiscard]] bool two_sided() const { return two_sided_; }

  /// Whether its i-th triangle sends light against a ray of that direction.
  [[nodiscard]] bool shines(std::uint32_t i, const Vec3<Unit>& direction) const {
    return two_sided_ || dot(direction, triangles_[i].normal) < 0;
  }
  /// A point of the light as seen from `p`; nothing when its back is turned.
  [[nodiscard]] std::optional<LightSample<N>> sample(LightPoints points, const Vec3<Length>& p,
                                                     std::uint32_t bits, Unit u, Unit v) const {
    if (may_use_solid_angle(points, p)) {
      const MeshSolidAngle<N> seen(triangles_, two_sided_, p);
      if (seen.is_sound()) {
        if (!seen.is_seen()) return std::nullopt;
        const auto point = seen.sample(bits, u, v);
        return sample_at(point.i, point.barycentric, p,
                         [&](const Vec3<Unit>& wi, Length) { return pdf_by_solid_angle(seen, point.i, wi); });
      }
    }
    const std::uint32_t i = chosen_.sample(bits);
    return sample_at(i, sample_triangle<N>(u, v), p,
                     [&](const Vec3<Unit>& wi, Length distance) { return pdf_by_area(i, wi, distance); });
  }

  /// The density with which sample() finds the point of its i-th triangle that a ray from `p` along `wi`
  /// meets after `distance`; 0 from behind.
  [[nodiscard]] Density pdf_w(LightPoints points, std::uint32_t i, const Vec3<Length>& p,
                              const Vec3<Unit>& wi, Length distance) const {
    if (may_use_solid_angle(points, p)) {
      const MeshSolidAngle<N> seen(triangles_, two_sided_, p);
      if (seen.is_sound()) return pdf_by_solid_angle(seen, i, wi);
    }
    return pdf_by_area(i, wi, distance);
  }

 private:
  // Whether it is worth a look: from farther away the light is certainly too small.
  [[nodiscard]] bool may_use_solid_angle(LightPoints points, const Vec3<Length>& p) const {
    if (points == LightPoints::kArea || triangles_.size() > MeshSolidAngle<N>::kMostTriangles) return false;
    const Vec3<Length> way = triangles_.front().corner - p;
    return dot(way, way) < solid_angle_reach_squared_;
  }
  // Of the light along `wi`; 0 or less from behind.
  [[nodiscard]] Unit cosine_at(std::uint32_t i, const Vec3<Unit>& wi) const {
    const Unit cosine = -dot(wi, triangles_[i].normal);
    return two_sided_ ? abs(cosine) : cosine;
  }
  // pdf_a d^2 / cos
  [[nodiscard]] Density pdf_by_area(std::uint32_t i, const Vec3<Unit>& wi, Length distance) const {
    const Unit cosine = cosine_at(i, wi);
    if (!(cosine > 0)) return Density(0);
    return pdf_a_[i] * Density(distance * distance) / Density(cosine);
  }
  [[nodiscard]] Density pdf_by_solid_angle(const MeshSolidAngle<N>& seen, std::uint32_t i,
                                           const Vec3<Unit>& wi) const {
    return cosine_at(i, wi) > 0 ? seen.pdf_w(i) : Density(0);
  }

  template <class PdfW>
  [[nodiscard]] std::optional<LightSample<N>> sample_at(std::uint32_t i, const Vec2<Unit>& b,
                                                        const Vec3<Length>& p, const PdfW& pdf_at) const {
    const EmissiveTriangle<N>& t = triangles_[i];
    const Vec3<Length> point = t.corner + t.edge_u * b.x + t.edge_v * b.y;
    const Vec3<Length> to_light = point - p;
    const Length distance = length(to_light);
    if (!(distance > 0)) return std::nullopt;
    const Vec3<Unit> wi = normalize(to_light);
    const Density pdf_w = pdf_at(wi, distance);
    if (!(pdf_w > 0)) return std::nullopt;
    const Vec3<Length> off = t.normal * ray_offset<N>();
    return LightSample<N>{.wi = wi,
                          .end = dot(wi, t.normal) < 0 ? point + off : point - off,
                          .radiance = {},
                          .pdf_w = pdf_w,
                          .triangle = t.triangle,
                          .barycentric = b};
  }

  std::vector<EmissiveTriangle<N>> triangles_;
  std::vector<Density> pdf_a_;
  DiscreteDistribution<N> chosen_;
  Area solid_angle_reach_squared_{};
  bool two_sided_;
};

}  // namespace vitrine
