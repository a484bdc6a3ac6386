// From the film to what a display shows: exposure, a tone curve, the sRGB transfer function.
//
// The curve is Reinhard's with a white point (2002, equation 4) on the luminance, Y (1 + Y / W^2) / (1 + Y);
// the colour keeps its ratios, and what then lies outside the display's range is clipped a channel at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "film/film.h"
#include "frame/exposure.h"
#include "numeric/color.h"

namespace vitrine {

/// The sRGB transfer function (IEC 61966-2-1): 8-bit codes of equal steps of linear light, fine enough that a
/// step is at most a fifth of a code.
using DisplayCurve = std::array<std::uint8_t, 1 << 14>;

/// Built once, on the host.
const DisplayCurve& srgb_display_curve();

/// Red, green, blue as the display takes them.
using DisplayCode = std::array<std::uint8_t, 3>;

/// `exposure`: exposure_factor() of the film's exponent.
template <class N>
DisplayCode tone_map(const Film::Pixel& pixel, typename N::Density exposure, const DisplayCurve& curve) {
  using Unit = typename N::Unit;
  using Radiance = typename N::Radiance;
  if (pixel.samples == 0) return {0, 0, 0};
  const auto exposed = [&](int c) { return N::from_film(pixel.sum[c], pixel.samples, kFilmBits) * exposure; };
  const Vec3<Radiance> color(exposed(0), exposed(1), exposed(2));
  const Radiance brightness = luminance<Unit>(color);
  constexpr Radiance kInverseWhiteSquared = Radiance(1.0 / 16.0);  // W = 4: two stops above 1 turn white
  const Radiance gain = (Radiance(1) + brightness * kInverseWhiteSquared) / (Radiance(1) + brightness);
  const auto code = [&](Radiance x) {
    const Radiance mapped = x * gain;
    const Unit linear = mapped < Radiance(1) ? Unit(mapped) : Unit(1);
    return curve[static_cast<std::size_t>(N::quantize(linear, static_cast<int>(curve.size()) - 1))];
  };
  return {code(color.x), code(color.y), code(color.z)};
}

}  // namespace vitrine
