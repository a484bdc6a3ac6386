// Sine, cosine and arc tangent of angles in turns, without a library call: an odd polynomial for a part of
// the turn, and symmetry. Turns suit fixed point: a random number is an angle as it is. Error 7e-9 (of an
// angle: 4e-11 turns) beside the rounding of the type.
#pragma once

namespace vitrine {

template <class Unit>
struct SinCos {
  Unit sin;
  Unit cos;
};

/// `turns` in [0, 1).
template <class Unit>
constexpr SinCos<Unit> sincos_turns(Unit turns) {
  // sin(pi/2 x) for x in [0, 1]: the Taylor series to x^13, whose next term is below 1e-9 there
  const auto quarter_sin = [](Unit x) {
    const Unit y = x * x;
    Unit p = Unit(0.0000000569217292);
    p = Unit(0.0000035988432352) - y * p;
    p = Unit(0.0001604411847874) - y * p;
    p = Unit(0.0046817541353187) - y * p;
    p = Unit(0.0796926262461670) - y * p;
    p = Unit(0.6459640975062463) - y * p;
    p = Unit(1.5707963267948966) - y * p;
    return x * p;
  };
  const bool lower = !(turns < Unit(0.5));
  const Unit half = lower ? turns - Unit(0.5) : turns;
  const bool second = !(half < Unit(0.25));
  const Unit quarter = second ? half - Unit(0.25) : half;
  const Unit x = (quarter + quarter) + (quarter + quarter);
  const Unit rising = quarter_sin(x);
  const Unit falling = quarter_sin(1 - x);
  const Unit sine = second ? falling : rising;
  const Unit cosine = second ? -rising : falling;
  return {lower ? -sine : sine, lower ? -cosine : cosine};
}

/// The angle of (x, y) against (1, 0) in turns, in [-1/2, 1/2]; 0 for (0, 0). |x| + |y| < 4, and a Unit's
/// resolution should be far below the larger of them.
template <class Unit>
constexpr Unit atan2_turns(Unit y, Unit x) {
  // atan(z) / (2 pi) for |z| <= tan(pi / 8): Chebyshev's interpolation of atan(z) / z over z^2
  const auto eighth_atan = [](Unit z) {
    const Unit s = z * z;
    Unit p = Unit(0.0095911626705223);
    p = Unit(0.0168224050285750) - s * p;
    p = Unit(0.0226629201181375) - s * p;
    p = Unit(0.0318280968385520) - s * p;
    p = Unit(0.0530516056162821) - s * p;
    p = Unit(0.1591549429918232) - s * p;
    return z * p;
  };
  const Unit abs_x = x < 0 ? -x : x;
  const Unit abs_y = y < 0 ? -y : y;
  const bool steep = abs_x < abs_y;
  const Unit longer = steep ? abs_y : abs_x;
  const Unit shorter = steep ? abs_x : abs_y;
  if (!(longer > 0)) return Unit(0);
  const Unit slope = shorter / longer;
  const bool diagonal =
      slope > Unit(0.4142135623730950);  // atan(slope) = pi/4 - atan((1 - slope) / (1 + slope))
  const Unit small = diagonal ? Unit(0.125) - eighth_atan((1 - slope) / (1 + slope)) : eighth_atan(slope);
  const Unit acute = steep ? Unit(0.25) - small : small;
  const Unit upper = x < 0 ? Unit(0.5) - acute : acute;
  return y < 0 ? -upper : upper;
}

}  // namespace vitrine
