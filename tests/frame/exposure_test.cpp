#include "frame/exposure.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/host_conversion.h"

namespace vitrine {
namespace {

/// A row of grey pixels of these radiances, in film units.
Film row(const std::vector<double>& values, int exponent = 0, std::uint32_t samples = 1) {
  Film film(static_cast<int>(values.size()), 1, exponent);
  for (int x = 0; x < film.width(); ++x) {
    const auto value = static_cast<std::int64_t>(std::ldexp(values[static_cast<std::size_t>(x)], kFilmBits));
    for (std::uint32_t i = 0; i < samples; ++i) film.add(x, 0, FilmValue(value));
  }
  return film;
}

template <class N>
class ExposureOf : public testing::Test {};
TYPED_TEST_SUITE(ExposureOf, NumberSystems, NumberSystemNames);

TYPED_TEST(ExposureOf, FactorIsAFourthRootOfTwoAStep) {
  for (int quarter_stops = -160; quarter_stops <= 160; ++quarter_stops) {
    for (const int exponent : {-20, 0, 3, 30}) {
      const double expected = std::exp2(quarter_stops / 4.0 + exponent);
      EXPECT_NEAR(to_host(exposure_factor<TypeParam>({quarter_stops}, exponent)), expected, 1e-6 * expected);
    }
  }
}

TYPED_TEST(ExposureOf, MeterTakesAnEvenPictureToMiddleGrey) {
  for (const double brightness : {1e-6, 0.003, 0.18, 1.0, 900.0}) {
    const Exposure exposure = meter_film<TypeParam>(row(std::vector<double>(100, brightness)));
    const double shown = brightness * std::exp2(exposure.quarter_stops / 4.0);
    EXPECT_GT(shown, 0.25 * std::exp2(-0.01)) << brightness;
    EXPECT_LT(shown, 0.25 * std::exp2(0.26)) << brightness;
  }
}

TYPED_TEST(ExposureOf, MeterFollowsAScaleExactly) {
  std::vector<double> values;
  for (int i = 1; i <= 200; ++i) values.push_back(0.0007 * i * i);
  const int base = meter_film<TypeParam>(row(values)).quarter_stops;
  // Brighter by 2^k: 4 k quarter stops fewer, be it in the sums, in the film's scale, or by more samples.
  for (const int k : {-12, -3, 1, 5}) {
    std::vector<double> scaled = values;
    for (double& x : scaled) x = std::ldexp(x, k);
    EXPECT_EQ(meter_film<TypeParam>(row(scaled)).quarter_stops, base - 4 * k);
    EXPECT_EQ(meter_film<TypeParam>(row(values, k)).quarter_stops, base - 4 * k);
  }
  EXPECT_EQ(meter_film<TypeParam>(row(values, 0, 16)).quarter_stops, base);
}

TYPED_TEST(ExposureOf, MeterHeedsNeitherDarknessNorABareLamp) {
  std::vector<double> values(1000, 0.5);
  const int base = meter_film<TypeParam>(row(values)).quarter_stops;
  for (std::size_t i = 0; i < 40; ++i) values[i] = 5000.0;  // a lamp on 4 % of the picture
  for (std::size_t i = 40; i < 300; ++i) values[i] = 1e-5;  // 26 % in the dark
  EXPECT_EQ(meter_film<TypeParam>(row(values)).quarter_stops, base);
  for (std::size_t i = 300; i < 900; ++i) values[i] = 0.0;  // black does not count at all
  for (std::size_t i = 0; i < 300; ++i) values[i] = 0.5;
  EXPECT_EQ(meter_film<TypeParam>(row(values)).quarter_stops, base);
}

TYPED_TEST(ExposureOf, MeterOfABlackOrEmptyFilmIsNeutral) {
  EXPECT_EQ(meter_film<TypeParam>(Film(4, 4, 12)), Exposure{});
  EXPECT_EQ(meter_film<TypeParam>(row({0.0, 0.0})), Exposure{});
}

TEST(Exposure, MeterDiffersByAStepAtMostBetweenNumberSystems) {
  std::vector<double> values;
  for (int i = 1; i <= 500; ++i) values.push_back(std::exp2(-20.0 + 0.05 * i));
  const Film film = row(values, 5, 3);
  EXPECT_NEAR(meter_film<FloatNumbers>(film).quarter_stops, meter_film<FixedNumbers>(film).quarter_stops, 1);
}

}  // namespace
}  // namespace vitrine
