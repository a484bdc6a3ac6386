// Uniform sampling of the solid angle that a triangle fills (Arvo 1995, "Stratified Sampling of Spherical
// Triangles"), by half angles instead of interior ones, which neither cancel for small triangles nor need an
// arc cosine. For unit directions a, b, c to the corners (Van Oosterom and Strackee 1983):
//
//   tan(solid angle / 2) = |a . (b x c)| / (1 + a.b + b.c + c.a)
//
// A part s = u * solid angle of the triangle ends at a point c' = a cos(phi) + t sin(phi) of its side a c,
// where t is the side's unit tangent at a. Put in, the formula is linear in tan(phi / 2):
//
//   tan(phi / 2) = (1 + a.b) sin(s/2) / (|a . (b x t)| cos(s/2) - b.t sin(s/2))
//
// On the arc from b to c' the height along b is uniform (Archimedes): z = 1 - v q, q = 1 - b.c'.
#pragma once

#include <algorithm>

#include "numeric/float_math.h"
#include "numeric/trigonometry.h"
#include "numeric/vec.h"

namespace vitrine {

template <class N>
class SphericalTriangle {
  using Unit = typename N::Unit;
  using Density = typename N::Density;

 public:
  SphericalTriangle() = default;
  /// The corners' unit directions.
  SphericalTriangle(const Vec3<Unit>& a, const Vec3<Unit>& b, const Vec3<Unit>& c)
      : cos_ab_(dot(a, b)), cos_ac_(dot(a, c)), half_1_ab_((1 + cos_ab_) * Unit(0.5)) {
    Vec3<Unit> across = c - a * cos_ac_;
    across = across - a * dot(a, across);  // of a short side, rounding had left much of a in it
    if (!(dot(across, across) > Unit(kLeastSide * kLeastSide))) return;  // not sound
    const Vec3<Unit> t = normalize(across);
    sin_ac_ = length(across);
    cos_bt_ = dot(b, t);
    volume_ = abs(dot(a, cross(b, t)));
    turns_ = atan2_turns(volume_ * sin_ac_ * Unit(0.5),
                         half_1_ab_ * (1 + cos_ac_) + cos_bt_ * sin_ac_ * Unit(0.5));
    sound_ = turns_ > Unit(kLeastTurns) && turns_ < Unit(kMostTurns) && half_1_ab_ > Unit(kNotOpposite) &&
             1 + cos_ac_ > Unit(kNotOpposite) && 1 + dot(b, c) > Unit(kNotOpposite);
  }

  /// Whether the arithmetic holds: neither a sliver nor almost a hemisphere.
  [[nodiscard]] bool is_sound() const { return sound_; }
  /// The solid angle over 4 pi.
  [[nodiscard]] Unit turns() const { return turns_; }
  [[nodiscard]] Density solid_angle() const { return Density(turns_) * Density(12.566370614359172); }

  /// Weights w of a direction along w.x a + w.y b + w.z c, uniform over the solid angle; none is below 0.
  [[nodiscard]] Vec3<Unit> sample(Unit u, Unit v) const {
    const SinCos<Unit> part = sincos_turns(u * turns_);
    const Vec3<Unit> half_phi = normalize(
        Vec3<Unit>((volume_ * part.cos - cos_bt_ * part.sin) * Unit(0.5), half_1_ab_ * part.sin, Unit(0)));
    const Unit sin_phi = (half_phi.x + half_phi.x) * half_phi.y;
    const Unit cos_phi = 1 - (half_phi.y + half_phi.y) * half_phi.y;
    const Unit q = std::max(Unit(0), 1 - (cos_phi * cos_ab_ + sin_phi * cos_bt_));
    // The shares of c' and b in the direction, times 2 - q, which keeps them small where q is almost 2.
    const Unit along = sqrt(v * (2 - v * q) * (2 - q));
    const Unit rest = (1 - v * q) * (2 - q) - along * (1 - q);
    const Unit sin_rest_of_ac = sin_ac_ * cos_phi - cos_ac_ * sin_phi;
    return {std::max(Unit(0), along * sin_rest_of_ac), std::max(Unit(0), rest * sin_ac_),
            std::max(Unit(0), along * sin_phi)};  // times the sine of a c
  }

 private:
  static constexpr double kLeastSide = 0x1p-11;    // sine of side a c
  static constexpr double kNotOpposite = 0x1p-11;  // of 1 + the cosine of a side
  static constexpr double kLeastTurns = 0x1p-22;
  static constexpr double kMostTurns = 0.48;

  Unit cos_ab_{};
  Unit cos_ac_{};
  Unit half_1_ab_{};  // (1 + a.b) / 2
  Unit sin_ac_{};
  Unit cos_bt_{};
  Unit volume_{};
  Unit turns_{};
  bool sound_ = false;
};

}  // namespace vitrine
