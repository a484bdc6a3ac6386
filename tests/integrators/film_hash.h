// A film's exact sums as one number: equal films, equal hashes (FNV-1a, 64 bits).
#pragma once

#include <cstdint>

#include "film/film.h"

namespace vitrine {

inline std::uint64_t film_hash(const Film& film) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&](std::uint64_t x) {
    for (int byte = 0; byte < 8; ++byte) {
      hash = (hash ^ (x >> (8 * byte) & 0xffU)) * 0x100000001b3U;
    }
  };
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      for (int c = 0; c < 3; ++c) add(static_cast<std::uint64_t>(film.at(x, y).sum[c]));
      add(film.at(x, y).luminance_squares.mantissa);
      add(static_cast<std::uint64_t>(film.at(x, y).luminance_squares.exponent));
      add(film.at(x, y).samples);
    }
  }
  return hash;
}

}  // namespace vitrine
