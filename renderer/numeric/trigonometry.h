// Sine and cosine of an angle in turns, without a library call: one odd polynomial for a quarter turn, and
// symmetry. Turns suit fixed point: a random number is an angle as it is. Error 7e-9 beside the rounding of
// the type.
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

}  // namespace vitrine
