// The regularised upper incomplete gamma function Q(a, x), which is the tail of the chi-square distribution:
// its series below the mean, Legendre's continued fraction (by Lentz) above (Abramowitz,
// Stegun 6.5.29, 6.5.31).
#pragma once

#include <cmath>

namespace vitrine {

/// Q(a, x) = Gamma(a, x) / Gamma(a), for a > 0, x >= 0.
inline double upper_incomplete_gamma(double a, double x) {
  constexpr double kPrecision = 1e-15;
  if (!(x > 0.0)) return 1.0;
  const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
  if (x < a + 1.0) {
    double term = 1.0 / a;
    double sum = term;
    for (double n = a + 1.0; term > sum * kPrecision; n += 1.0) {
      term *= x / n;
      sum += term;
    }
    return 1.0 - scale * sum;
  }
  double b = x + 1.0 - a;
  double c = 1e300;
  double d = 1.0 / b;
  double fraction = d;
  for (int i = 1; i < 100000; ++i) {
    const double numerator = -i * (i - a);
    b += 2.0;
    d = 1.0 / (numerator * d + b);
    c = b + numerator / c;
    fraction *= c * d;
    if (std::abs(c * d - 1.0) < kPrecision) break;
  }
  return scale * fraction;
}

}  // namespace vitrine
