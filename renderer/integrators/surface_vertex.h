// A path's vertex on a surface, shared by every estimator: the point, the local frame that faces the viewer,
// and the BSDF there. A shading normal that the viewer cannot see gives way to the geometric one, and a
// direction counts as reflected or transmitted only if both normals agree.
#pragma once

#include <optional>

#include "geometry/basis.h"
#include "lights/light_selection.h"
#include "materials/bsdf.h"
#include "scene/world.h"

namespace vitrine {

template <class N>
class SurfaceVertex {
  using Unit = typename N::Unit;
  using Length = typename N::Length;

 public:
  SurfaceVertex(const World<N>& world, const Ray<N>& ray, const Hit<N>& hit, DirectionSampling how)
      : SurfaceVertex(world, hit, world.surface_point(hit), -ray.direction, how) {}

  [[nodiscard]] const Vec3<Length>& position() const { return position_; }
  [[nodiscard]] const Bsdf<N>& bsdf() const { return bsdf_; }
  /// The vertex as the choice of a light sees it.
  [[nodiscard]] Receiver<N> receiver() const { return {position_, facing_, bsdf_.is_rough_both_sides()}; }
  [[nodiscard]] Vec3<Unit> to_local(const Vec3<Unit>& w) const { return frame_.to_local(w); }
  [[nodiscard]] Vec3<Unit> to_world(const Vec3<Unit>& w) const { return frame_.to_world(w); }

  /// Whether world direction `wi`, local `wi_local`, leaves on the same side by both normals.
  [[nodiscard]] bool sides_agree(const Vec3<Unit>& wi, const Vec3<Unit>& wi_local) const {
    return (dot(wi, facing_) > 0) == (wi_local.z > 0);
  }
  /// The solid that a ray along local `wi` is in, where the one that arrived was in `arrived`: another one if
  /// it goes through a solid's boundary.
  [[nodiscard]] std::uint32_t solid_towards(const Vec3<Unit>& wi, std::uint32_t arrived) const {
    return wi.z < 0 && beyond_ ? *beyond_ : arrived;
  }
  /// The ray along `wi`, from just off the surface on the side that it leaves to.
  [[nodiscard]] Ray<N> ray_along(const Vec3<Unit>& wi) const { return {start(wi), wi, far_away<N>()}; }
  /// The ray that leaves along about `wi` and ends at `end`; nothing if no ray fits between.
  [[nodiscard]] std::optional<Ray<N>> ray_to(const Vec3<Length>& end, const Vec3<Unit>& wi) const {
    const Vec3<Length> from = start(wi);
    const Length distance = length(end - from);
    if (!(distance > ray_offset<N>())) return std::nullopt;
    return Ray<N>{from, normalize(end - from), distance};
  }

 private:
  [[nodiscard]] Vec3<Length> start(const Vec3<Unit>& wi) const {
    const Vec3<Length> off = facing_ * ray_offset<N>();
    return dot(wi, facing_) < 0 ? position_ - off : position_ + off;
  }

  SurfaceVertex(const World<N>& world, const Hit<N>& hit, const SurfacePoint<N>& point, const Vec3<Unit>& wo,
                DirectionSampling how)
      : SurfaceVertex(world, hit, point, wo, how, dot(wo, point.geometric_normal) < 0) {}
  SurfaceVertex(const World<N>& world, const Hit<N>& hit, const SurfacePoint<N>& point, const Vec3<Unit>& wo,
                DirectionSampling how, bool behind)
      : position_(point.position),
        facing_(behind ? -point.geometric_normal : point.geometric_normal),
        frame_(visible_normal(behind ? -point.normal : point.normal, wo)),
        bsdf_(world.material(hit.triangle)
                  .scattering(world.coordinates(hit.triangle, hit.u, hit.v), behind, world.srgb_table,
                              world.linear_table),
              frame_.to_local(wo), how) {
    if (world.material(hit.triangle).solid) {
      beyond_ = behind ? kOutside : world.triangles[hit.triangle].material;
    }
  }

  [[nodiscard]] Vec3<Unit> visible_normal(const Vec3<Unit>& normal, const Vec3<Unit>& wo) const {
    return dot(normal, wo) > Unit(0.0001) ? normal : facing_;
  }

  Vec3<Length> position_;
  Vec3<Unit> facing_;  // the geometric normal, towards the viewer
  Basis<N> frame_;
  Bsdf<N> bsdf_;
  std::optional<std::uint32_t> beyond_;  // behind the boundary of a solid, as the viewer sees it
};

}  // namespace vitrine
