// An orthonormal basis around a normal, without a branch that could tear (Duff et al. 2017).
#pragma once

#include "numeric/vec.h"

namespace vitrine {

template <class N>
class Basis {
  using Unit = typename N::Unit;

 public:
  explicit Basis(const Vec3<Unit>& n) : n_(n) {
    const bool down = n.z < 0;
    const Unit sign = down ? Unit(-1) : Unit(1);
    const Unit a = -(sign / (1 + abs(n.z)));
    const Unit xy = n.x * n.y * a;
    const Unit xx = n.x * n.x * a;
    s_ = {1 + (down ? -xx : xx), down ? -xy : xy, down ? n.x : -n.x};
    t_ = {xy, sign + n.y * n.y * a, -n.y};
  }

  [[nodiscard]] const Vec3<Unit>& normal() const { return n_; }
  [[nodiscard]] Vec3<Unit> to_local(const Vec3<Unit>& v) const {
    return {dot(v, s_), dot(v, t_), dot(v, n_)};
  }
  [[nodiscard]] Vec3<Unit> to_world(const Vec3<Unit>& v) const { return s_ * v.x + t_ * v.y + n_ * v.z; }

 private:
  Vec3<Unit> s_;
  Vec3<Unit> t_;
  Vec3<Unit> n_;
};

}  // namespace vitrine
