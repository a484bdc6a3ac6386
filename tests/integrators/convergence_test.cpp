// With independent samples the error falls as one over the square root of their number: half of it by four
// times the samples, a slope of -1/2 in a log-log plot of RMSE over samples per pixel. A bias, or samples
// that repeat, would bend the line.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "integrators/ways.h"
#include "statistics/picture.h"

namespace vitrine {
namespace {

constexpr int kSize = 32;

/// Means of all pixels' channels of samples [first, first + count).
std::vector<double> render_pixels(const Renderer& renderer, SampleRange samples) {
  Film film = renderer.make_film();
  const std::atomic<bool> cancel{false};
  for_each_on_all_cores(kSize, [&](int y) { renderer.trace({0, y, kSize, y + 1}, samples, film, cancel); });
  std::vector<double> pixels;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      for (int c = 0; c < 3; ++c) pixels.push_back(film.mean_nits(x, y)[c]);
    }
  }
  return pixels;
}

double slope(const std::vector<double>& x, const std::vector<double>& y) {
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / static_cast<double>(x.size());
    mean_y += y[i] / static_cast<double>(x.size());
  }
  double xy = 0.0;
  double xx = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    xx += (x[i] - mean_x) * (x[i] - mean_x);
  }
  return xy / xx;
}

struct Way {
  Numbers numbers;
  std::string mode;
};

class Convergence : public testing::TestWithParam<Way> {};

TEST_P(Convergence, HasSlopeMinusOneHalf) {
  const auto scene = bake(project_scene("cornell"), GetParam().numbers);
  const auto renderer = [&](const char* mode, std::uint64_t seed) {
    return scene->make_renderer({.mode = find_mode(mode), .width = kSize, .height = kSize, .seed = seed});
  };
  // Two references of another seed: E[(a - r)(a - s)] is a's squared error against the truth, whatever the
  // noise of r and s, since the three are independent.
  const auto reference = renderer("mis", 1000);
  const std::vector<double> r = render_pixels(*reference, {0, 512});
  const std::vector<double> s = render_pixels(*reference, {512, 512});
  const auto tried = renderer(GetParam().mode.c_str(), 1);
  std::vector<double> log_samples;
  std::vector<double> log_error;
  for (std::uint32_t samples = 4; samples <= 256; samples *= 2) {
    const std::vector<double> a = render_pixels(*tried, {samples, samples});  // disjoint for every `samples`
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - r[i]) * (a[i] - s[i]);
    ASSERT_GT(squares, 0.0);
    log_samples.push_back(std::log(samples));
    log_error.push_back(0.5 * std::log(squares / static_cast<double>(a.size())));
  }
  EXPECT_NEAR(slope(log_samples, log_error), -0.5, 0.05);
}

std::vector<Way> ways() {
  std::vector<Way> all;
  for (const Numbers numbers : {Numbers::kFloat, Numbers::kFixed}) {
    for (const char* mode : {"basic", "nee", "mis"}) all.push_back({numbers, mode});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Cornell, Convergence, testing::ValuesIn(ways()), [](const auto& test) {
  return test_name(std::string(numbers_name(test.param.numbers)) + "_" + test.param.mode);
});

}  // namespace
}  // namespace vitrine
