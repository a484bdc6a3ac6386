#include "frame/tone_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <gtest/gtest.h>

#include "number_systems.h"

namespace vitrine {
namespace {

Film::Pixel pixel_of(const glm::dvec3& radiance, std::uint32_t samples = 1) {
  Film::Pixel pixel;
  pixel.samples = samples;
  for (int c = 0; c < 3; ++c) {
    pixel.sum[c] = static_cast<std::int64_t>(std::ldexp(radiance[c], kFilmBits)) * samples;
  }
  return pixel;
}

template <class N>
DisplayCode mapped(const glm::dvec3& radiance, int quarter_stops = 0) {
  return tone_map<N>(pixel_of(radiance), exposure_factor<N>({quarter_stops}, 0), srgb_display_curve());
}

double srgb_encode(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055; }

/// The curve by its formula, in the host's arithmetic: linear light of a channel.
double formula(double x, double luminance) {
  return std::min(1.0, x * (1.0 + luminance / 16.0) / (1.0 + luminance));
}

template <class N>
class ToneMap : public testing::Test {};
TYPED_TEST_SUITE(ToneMap, NumberSystems, NumberSystemNames);

TYPED_TEST(ToneMap, BlackIsBlackAndFourTimesWhiteIsWhite) {
  EXPECT_EQ(mapped<TypeParam>({0, 0, 0}), (DisplayCode{0, 0, 0}));
  EXPECT_EQ(tone_map<TypeParam>(Film::Pixel{}, exposure_factor<TypeParam>({}, 0), srgb_display_curve()),
            (DisplayCode{0, 0, 0}));
  EXPECT_EQ(mapped<TypeParam>({4.0, 4.0, 4.0}), (DisplayCode{255, 255, 255}));
  EXPECT_EQ(mapped<TypeParam>({1e6, 1e6, 1e6}), (DisplayCode{255, 255, 255}));
  EXPECT_LT(mapped<TypeParam>({3.8, 3.8, 3.8})[0], 255);
}

TYPED_TEST(ToneMap, IsMonotoneAndFollowsItsFormula) {
  int last = 0;
  for (double x = 1e-4; x < 10.0; x *= 1.01) {
    const int code = mapped<TypeParam>(glm::dvec3(x))[1];
    EXPECT_GE(code, last) << x;
    EXPECT_NEAR(code, 255.0 * srgb_encode(formula(x, x)), 0.8)
        << x;  // half a code, and a fifth for the table's step
    last = code;
  }
  EXPECT_EQ(last, 255);
}

TYPED_TEST(ToneMap, KeepsTheHue) {
  const auto decode = [](int code) {
    const double x = code / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  for (const double brightness : {0.3, 1.0, 2.0}) {
    const DisplayCode codes = mapped<TypeParam>(glm::dvec3(0.5, 0.25, 0.125) * brightness);
    EXPECT_NEAR(decode(codes[1]) / decode(codes[0]), 0.5, 0.02) << brightness;
    EXPECT_NEAR(decode(codes[2]) / decode(codes[0]), 0.25, 0.02) << brightness;
  }
  // Where a channel leaves the display's range it is clipped, and the others stay.
  const double luminance = 0.2126 * 8.0 + 0.7152 * 0.5;
  EXPECT_EQ(mapped<TypeParam>({8.0, 0.5, 0.0})[0], 255);
  EXPECT_NEAR(mapped<TypeParam>({8.0, 0.5, 0.0})[1], 255.0 * srgb_encode(formula(0.5, luminance)), 0.8);
  EXPECT_EQ(mapped<TypeParam>({8.0, 0.5, 0.0})[2], 0);
}

TYPED_TEST(ToneMap, ExposureActsAsALight) {
  EXPECT_EQ(mapped<TypeParam>(glm::dvec3(0.4, 0.2, 0.1), 8), mapped<TypeParam>(glm::dvec3(1.6, 0.8, 0.4)));
  EXPECT_EQ(mapped<TypeParam>(glm::dvec3(0.4, 0.2, 0.1), -4), mapped<TypeParam>(glm::dvec3(0.2, 0.1, 0.05)));
}

TYPED_TEST(ToneMap, ShowsTheMeanOfTheSamples) {
  const auto factor = exposure_factor<TypeParam>({}, 0);
  EXPECT_EQ(tone_map<TypeParam>(pixel_of({0.3, 0.2, 0.1}, 1000), factor, srgb_display_curve()),
            mapped<TypeParam>({0.3, 0.2, 0.1}));
}

TEST(ToneMapOfBothNumberSystems, DiffersByACodeAtMost) {
  for (double x = 1e-5; x < 100.0; x *= 1.07) {
    for (const glm::dvec3& tint : {glm::dvec3(1.0), glm::dvec3(1.0, 0.3, 0.02), glm::dvec3(0.1, 0.2, 0.9)}) {
      const DisplayCode a = mapped<FloatNumbers>(tint * x, 3);
      const DisplayCode b = mapped<FixedNumbers>(tint * x, 3);
      for (std::size_t c = 0; c < 3; ++c) EXPECT_LE(std::abs(a[c] - b[c]), 1) << x << " channel " << c;
    }
  }
}

TEST(DisplayCurve, IsSrgbInStepsOfAFifthOfACodeAtMost) {
  const DisplayCurve& curve = srgb_display_curve();
  EXPECT_EQ(curve.front(), 0);
  EXPECT_EQ(curve.back(), 255);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(curve.size() - 1);
    EXPECT_EQ(curve[i], std::lround(255.0 * srgb_encode(x))) << i;
  }
  EXPECT_LE(255.0 * srgb_encode(1.0 / static_cast<double>(curve.size() - 1)), 0.21);
}

}  // namespace
}  // namespace vitrine
