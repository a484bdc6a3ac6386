// How good a picture is, told from the picture alone. The n samples of a pixel are independent, so its mean m
// (of luminance) has the variance
//   V = (Q / n - m^2) / (n - 1),     Q: the sum of their squares,
// and the picture the relative error mean sqrt(V) / mean m, means over its pixels: by how much of the
// picture's brightness a pixel is off. (By squares, a few fireflies would speak for all.) An estimate of
// noise: it cannot see a bias, nor light that no sample has found yet; where samples are spread more evenly
// than chance would (stratified, Sobol), the error is smaller than it says. All in integers, whatever traced
// the film.
#pragma once

#include <cstdint>
#include <optional>

#include "film/film.h"
#include "numeric/wide.h"

namespace vitrine {

/// A pixel's mean luminance, in film values, and the variance of that mean.
struct PixelError {
  Wide mean;
  Wide variance;
};

/// Nothing for a pixel of fewer than two samples.
std::optional<PixelError> pixel_error(const Film::Pixel& pixel);

/// What pixels add up to.
struct ErrorSums {
  Wide means = Wide::zero();
  Wide deviations = Wide::zero();

  ErrorSums& operator+=(const ErrorSums& other) {
    means += other.means;
    deviations += other.deviations;
    return *this;
  }
};

/// Over the pixels of `tile` that tell an error.
ErrorSums sum_errors(const Film& film, const Tile& tile);

/// Of the pixels that were summed, 1 being 100 %; nothing when all are black or none tells an error.
std::optional<Wide> relative_error(const ErrorSums& sums);

}  // namespace vitrine
