#include "film/film.h"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

namespace vitrine {
namespace {

constexpr std::int64_t kOne = std::int64_t{1} << kFilmBits;

TEST(Film, BeginsBlackAndEmpty) {
  const Film film(3, 2, 0);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      EXPECT_EQ(film.at(x, y).samples, 0U);
      EXPECT_EQ(film.mean_nits(x, y), glm::dvec3(0.0));
    }
  }
}

TEST(Film, AddsToOnePixelExactly) {
  Film film(3, 2, 0);
  // A bright sample must not swallow the smallest ones, in whatever order they come.
  film.add(2, 1, {kFilmSampleLimit - 1, 0, 1});
  for (int i = 0; i < 1000; ++i) film.add(2, 1, {1, 0, kOne});
  EXPECT_EQ(film.at(2, 1).sum, FilmValue(kFilmSampleLimit + 999, 0, 1000 * kOne + 1));
  EXPECT_EQ(film.at(2, 1).samples, 1001U);
  EXPECT_EQ(film.at(1, 1).samples, 0U);
  EXPECT_EQ(film.at(2, 0).samples, 0U);
}

TEST(Film, MeanIsInNits) {
  Film film(1, 1, 0);
  film.add(0, 0, {kOne, 2 * kOne, 0});
  film.add(0, 0, {2 * kOne, 2 * kOne, kOne});
  EXPECT_EQ(film.mean_nits(0, 0), glm::dvec3(1.5, 2.0, 0.5));
}

TEST(Film, ExponentScalesFromMoonlessToTheSun) {
  for (const int exponent : {-20, -1, 0, 7, 31}) {
    Film film(1, 1, exponent);
    film.add(0, 0, {kOne, kOne / 2, 3 * kOne});
    EXPECT_EQ(film.mean_nits(0, 0), glm::dvec3(1.0, 0.5, 3.0) * std::ldexp(1.0, exponent));
  }
}

TEST(Film, SaturatesRatherThanTurnsNegative) {
  Film film(1, 1, 0);
  for (int i = 0; i < 1000; ++i) film.add(0, 0, {kFilmSampleLimit - 1, 0, 0});
  EXPECT_GT(film.at(0, 0).sum.x, std::int64_t{1} << 62);
}

}  // namespace
}  // namespace vitrine
