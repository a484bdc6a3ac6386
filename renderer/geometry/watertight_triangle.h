// Ray against triangle without leaks (Woop, Benthin, Wald 2013). The ray is sheared onto an axis; a vertex'
// sheared position depends on ray and vertex alone, so the triangles that share an edge see the same edge
// function with opposite sign, and a ray aimed at the edge hits at least one of them. In fixed point the edge
// functions are exact.
#pragma once

#include "geometry/ray.h"
#include "numeric/vec.h"

namespace vitrine {

/// A ray prepared for triangles: permuted so that its direction is largest along kz, and the shear.
template <class N>
class ShearedRay {
  using Unit = typename N::Unit;
  using Length = typename N::Length;
  using Area = typename N::Area;

 public:
  explicit ShearedRay(const Ray<N>& ray) : origin_(ray.origin) {
    const Vec3<Unit>& d = ray.direction;
    const Unit x = abs(d.x);
    const Unit y = abs(d.y);
    const Unit z = abs(d.z);
    kz_ = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    kx_ = (kz_ + 1) % 3;
    ky_ = (kz_ + 2) % 3;
    shear_z_ = Unit(1) / d[kz_];
    shear_x_ = d[kx_] * shear_z_;
    shear_y_ = d[ky_] * shear_z_;
  }

  /// Shortens hit.t and fills the rest of `hit` but its triangle if the triangle a, b, c is hit before hit.t.
  bool intersect(const Vec3<Length>& a, const Vec3<Length>& b, const Vec3<Length>& c, Hit<N>& hit) const {
    const Sheared p = shear(a);
    const Sheared q = shear(b);
    const Sheared r = shear(c);
    const Area edge_a = r.x * q.y - r.y * q.x;
    const Area edge_b = p.x * r.y - p.y * r.x;
    const Area edge_c = q.x * p.y - q.y * p.x;
    if ((edge_a < 0 || edge_b < 0 || edge_c < 0) && (edge_a > 0 || edge_b > 0 || edge_c > 0)) return false;
    const Area det = edge_a + edge_b + edge_c;
    if (det == 0) return false;
    const Unit u = edge_b / det;
    const Unit v = edge_c / det;
    const Length t = (p.z * (1 - u - v) + q.z * u + r.z * v) * shear_z_;
    if (!(t > 0) || !(t < hit.t)) return false;
    hit.t = t;
    hit.u = u;
    hit.v = v;
    return true;
  }

 private:
  struct Sheared {
    Length x, y, z;
  };
  [[nodiscard]] Sheared shear(const Vec3<Length>& vertex) const {
    const Vec3<Length> p = vertex - origin_;
    return {p[kx_] - p[kz_] * shear_x_, p[ky_] - p[kz_] * shear_y_, p[kz_]};
  }

  Vec3<Length> origin_;
  Unit shear_x_, shear_y_, shear_z_;
  int kx_, ky_, kz_;
};

}  // namespace vitrine
