#include "film/film.h"

#include <cmath>

namespace vitrine {

glm::dvec3 Film::mean_nits(int x, int y) const {
  const Pixel& pixel = at(x, y);
  if (pixel.samples == 0) return glm::dvec3(0.0);
  return glm::dvec3(pixel.sum) * (std::ldexp(1.0, exponent_ - kFilmBits) / pixel.samples);
}

}  // namespace vitrine
