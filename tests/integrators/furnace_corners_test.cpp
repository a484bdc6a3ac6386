// The furnace by next event estimation. Where two walls meet, a vertex at the distance x from the edge finds
// light worth up to about 1 / x^2 with a probability of about x^3, so what a sample brings has a Pareto tail
// of exponent 3/2: a mean, but no variance. The mean of n samples then lacks what only more of them would
// have found. This test knows the tail's exponent, so it takes the mean of all samples below a threshold T as
// they are, and replaces the few beyond it by the mean of that tail, 3 T (Peng 2001, "Estimating the mean of
// a heavy tailed distribution").
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "statistics/picture.h"

namespace vitrine {
namespace {

constexpr int kSize = 256;
constexpr int kFilms = 512;  // of one sample a pixel
constexpr double kTailShare = 1e-5;
constexpr double kTailMean = 3.0;  // of a Pareto tail of exponent 3/2 beyond T, in units of T

class FurnaceCorners : public testing::TestWithParam<Numbers> {};

TEST_P(FurnaceCorners, NextEventEstimationShowsTwiceTheEmission) {
  const auto scene = bake(project_scene("furnace"), GetParam());
  const auto renderer =
      scene->make_renderer({.mode = find_mode("nee"), .width = kSize, .height = kSize, .seed = 1});
  constexpr std::size_t kPixels = std::size_t{kSize} * kSize;
  std::vector<float> found(kPixels * kFilms);  // a sample each, in units of the answer
  for_each_on_all_cores(kFilms, [&](int i) {
    Film film = renderer->make_film();
    const std::atomic<bool> cancel{false};
    renderer->trace({0, 0, kSize, kSize}, {static_cast<std::uint32_t>(i), 1}, film, cancel);
    for (std::size_t p = 0; p < kPixels; ++p) {
      const glm::dvec3 nits = film.mean_nits(static_cast<int>(p) % kSize, static_cast<int>(p) / kSize);
      found[static_cast<std::size_t>(i) * kPixels + p] = static_cast<float>(nits.y / (2.0 * 0.25));
    }
  });
  const auto count = static_cast<double>(found.size());
  const auto tail = static_cast<std::ptrdiff_t>(count * kTailShare);
  std::nth_element(found.begin(), found.end() - tail, found.end());
  const auto threshold = static_cast<double>(*(found.end() - tail));
  double sum = 0.0;
  double squares = 0.0;
  for (auto x = found.begin(); x != found.end() - tail; ++x) {
    sum += static_cast<double>(*x);
    squares += static_cast<double>(*x) * static_cast<double>(*x);
  }
  const double tail_mass = static_cast<double>(tail) / count * kTailMean * threshold;
  const double error =
      std::sqrt(squares / (count * count) + tail_mass * tail_mass / static_cast<double>(tail));
  const double mean = sum / count + tail_mass;
  RecordProperty("mean", std::to_string(mean));
  RecordProperty("standard_error", std::to_string(error));
  EXPECT_LT(3.0 * error, 0.002) << "too few samples to judge";
  EXPECT_NEAR(mean, 1.0, 0.002);
}

INSTANTIATE_TEST_SUITE_P(Numbers, FurnaceCorners, testing::Values(Numbers::kFloat, Numbers::kFixed),
                         [](const auto& test) { return std::string(numbers_name(test.param)); });

}  // namespace
}  // namespace vitrine
