// Exposure in quarter stops: radiance in nits is multiplied by 2^(quarter_stops / 4) before the tone curve.
// And the light meter that chooses one.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "film/film.h"
#include "numeric/color.h"

namespace vitrine {

struct Exposure {
  int quarter_stops = 0;

  bool operator==(const Exposure&) const = default;
};

/// The factor of an exposure on the radiance of a film of the given exponent.
template <class N>
typename N::Density exposure_factor(Exposure exposure, int film_exponent) {
  using Density = typename N::Density;
  const int stops = exposure.quarter_stops + 4 * film_exponent;
  const int whole = stops >> 2;
  constexpr std::array kQuarter{Density(1.0), Density(1.189207115002721), Density(1.4142135623730951),
                                Density(1.681792830507429)};
  Density factor = kQuarter[static_cast<std::size_t>(stops & 3)];
  for (int i = 0; i < whole; ++i) factor *= Density(2);
  for (int i = 0; i > whole; --i) factor *= Density(0.5);
  return factor;
}

/// The exposure that takes the picture's middle luminance to middle grey: the mean of log luminance between
/// the 30th and the 95th percentile of the lit pixels, so that neither a dark room nor a bare lamp decides.
template <class N>
Exposure meter_film(const Film& film) {
  using Unit = typename N::Unit;
  constexpr int kBins = 4 * 64;  // quarter stops; a film value spans fewer than 64 stops
  constexpr int kLowest = -4 * kFilmBits - 4;
  constexpr int kMiddleGrey = -8;  // quarter stops: 0.25, which the tone curve takes to 0.2
  std::array<std::int64_t, kBins> histogram{};
  std::int64_t lit = 0;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const Film::Pixel& pixel = film.at(x, y);
      if (pixel.samples == 0) continue;
      const auto mean = [&](int c) { return N::from_film(pixel.sum[c], pixel.samples, kFilmBits); };
      const auto brightness = luminance<Unit>(Vec3<typename N::Radiance>(mean(0), mean(1), mean(2)));
      if (!(brightness > 0)) continue;
      ++histogram[static_cast<std::size_t>(std::clamp(N::quarter_stop(brightness) - kLowest, 0, kBins - 1))];
      ++lit;
    }
  }
  if (lit == 0) return {};
  std::int64_t passed = 0;
  std::int64_t counted = 0;
  std::int64_t total = 0;
  for (int bin = 0; bin < kBins; ++bin) {
    const std::int64_t from = std::max(passed, lit * 30 / 100);
    passed += histogram[static_cast<std::size_t>(bin)];
    const std::int64_t inside = std::max<std::int64_t>(0, std::min(passed, (lit * 95 + 99) / 100) - from);
    counted += inside;
    total += inside * bin;
  }
  const int middle = static_cast<int>(total / std::max<std::int64_t>(1, counted)) + kLowest;
  return {kMiddleGrey - middle - 4 * film.exponent()};
}

}  // namespace vitrine
