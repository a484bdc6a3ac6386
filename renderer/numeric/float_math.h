// The functions of fixed.h and wide.h for float, so that code written over a number system finds either.
#pragma once

#include <cmath>

namespace vitrine {

inline float sqrt(float x) { return std::sqrt(x > 0 ? x : 0.0F); }
inline float abs(float x) { return std::fabs(x); }
constexpr float square(float x) { return x * x; }
inline bool is_finite(float x) { return std::isfinite(x); }

}  // namespace vitrine
