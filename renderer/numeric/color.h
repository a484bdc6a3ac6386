// Rec.709 colour.
#pragma once

#include "numeric/vec.h"

namespace vitrine {

/// Luminance of a linear Rec.709 colour of any quantity T; Unit is the number system's scalar.
template <class Unit, class T>
constexpr T luminance(const Vec3<T>& c) {
  return c.x * Unit(0.2126) + c.y * Unit(0.7152) + c.z * Unit(0.0722);
}

}  // namespace vitrine
