// Between the host's arithmetic and a quantity of either number system: for baking and for tests, never on a
// path.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "numeric/vec.h"

namespace vitrine {

/// The nearest value of quantity Q; saturates at the range of a fixed one.
template <class Q>
Q from_host(double x) {
  if constexpr (std::floating_point<Q>) {
    return static_cast<Q>(x);
  } else if constexpr (std::same_as<Q, Wide>) {
    if (!(x > 0)) return Wide::zero();
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);  // in [0.5, 1)
    return Wide::normalized(static_cast<std::uint64_t>(std::ldexp(mantissa, 63)), exponent - 63);
  } else {
    using Rep = decltype(Q::raw);
    const double limit = std::ldexp(1.0, static_cast<int>(sizeof(Rep)) * 8 - 1) * (1.0 - 0x1p-32);
    return Q::from_raw(
        static_cast<Rep>(std::clamp(std::nearbyint(x / to_host(Q::from_raw(1))), -limit, limit)));
  }
}

template <std::floating_point Q>
double to_host(Q x) {
  return static_cast<double>(x);
}
inline double to_host(Wide x) {
  return x.mantissa == 0 ? 0.0 : std::ldexp(static_cast<double>(x.mantissa), x.exponent);
}
template <int B, class Rep>
double to_host(Fixed<B, Rep> x) {
  return std::ldexp(static_cast<double>(x.raw), -B);
}

template <class Q, class T>
Vec3<Q> from_host(const glm::vec<3, T, glm::defaultp>& v) {
  return {from_host<Q>(static_cast<double>(v.x)), from_host<Q>(static_cast<double>(v.y)),
          from_host<Q>(static_cast<double>(v.z))};
}
template <class Q>
glm::dvec3 to_host(const Vec3<Q>& v) {
  return {to_host(v.x), to_host(v.y), to_host(v.z)};
}

}  // namespace vitrine
