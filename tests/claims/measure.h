// How good a way of sampling is: the variance of its pictures at equal samples, from pictures of several
// seeds, and their squared error against a reference at equal time. Both are relative to the square of the
// pixel's value (and a hundredth of the mean picture's, so that black pixels do not decide).
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <string_view>
#include <vector>

#include "numeric/color.h"
#include "statistics/picture.h"
#include "technique.h"

namespace vitrine {

/// The parts of a technique, "KEY NAME=VALUE ...".
inline SamplingParts sampling(std::string_view technique) { return parse_technique(technique).parts; }

/// A picture as luminances in nits, row by row.
using Luminances = std::vector<double>;

inline Luminances luminances(const Film& film) {
  Luminances values;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) values.push_back(luminance<double>(film.mean_nits(x, y)));
  }
  return values;
}

/// One picture of `spp` samples a pixel on the calling thread.
inline Luminances render_luminances(const BakedScene& scene, const SamplingParts& parts, int size,
                                    std::uint32_t spp, std::uint64_t seed,
                                    int max_depth = RenderOptions{}.max_depth) {
  const auto renderer = scene.make_renderer({.mode = &modes().front(),
                                             .parts = parts,
                                             .width = size,
                                             .height = size,
                                             .seed = seed,
                                             .max_depth = max_depth});
  Film film = renderer->make_film();
  const std::atomic<bool> cancel{false};
  renderer->trace({0, 0, size, size}, {0, spp}, film, cancel);
  return luminances(film);
}

/// The same for seeds first .. first + count - 1, on all cores.
inline std::vector<Luminances> render_seeds(const BakedScene& scene, const SamplingParts& parts, int size,
                                            std::uint32_t spp, std::uint64_t first, int count) {
  std::vector<Luminances> pictures(static_cast<std::size_t>(count));
  for_each_on_all_cores(count, [&](int i) {
    pictures[static_cast<std::size_t>(i)] =
        render_luminances(scene, parts, size, spp, first + static_cast<std::uint64_t>(i));
  });
  return pictures;
}

inline Luminances mean_picture(const std::vector<Luminances>& pictures) {
  Luminances mean(pictures.front().size(), 0.0);
  for (const Luminances& picture : pictures) {
    for (std::size_t i = 0; i < mean.size(); ++i)
      mean[i] += picture[i] / static_cast<double>(pictures.size());
  }
  return mean;
}

/// The pixels that count: all, or those that see nothing but one material.
using Mask = std::vector<bool>;

inline Mask see_material(Scene scene, std::string_view name, int size) {
  for (Material& material : scene.materials) {
    material.emission = glm::vec3(material.name == name ? 1.0F : 0.0F);
    material.emission_texture = {};
  }
  scene.lights.clear();
  scene.environment.reset();
  const Luminances seen =
      render_luminances(*bake(scene, Numbers::kFloat), modes().front().parts, size, 16, 1, 0);
  Mask mask;
  for (const double value : seen) mask.push_back(value > 0.999);
  return mask;
}

/// 1 / (reference^2 + a hundredth of its mean square) where the mask is set, 0 elsewhere, summing up to 1
/// over a picture of relative error 1.
inline std::vector<double> pixel_weights(const Luminances& reference, const Mask& mask) {
  double squares = 0.0;
  for (const double value : reference) squares += value * value / static_cast<double>(reference.size());
  const auto counted = static_cast<double>(std::ranges::count(mask, true));
  std::vector<double> weights;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const double value = reference[i];
    weights.push_back(mask[i] ? 1.0 / (value * value + 0.01 * squares) / counted : 0.0);
  }
  return weights;
}

/// The mean relative variance of one such picture.
inline double relative_variance(const std::vector<Luminances>& pictures, const std::vector<double>& weights) {
  const Luminances mean = mean_picture(pictures);
  double sum = 0.0;
  for (const Luminances& picture : pictures) {
    for (std::size_t i = 0; i < mean.size(); ++i) {
      sum += weights[i] * (picture[i] - mean[i]) * (picture[i] - mean[i]);
    }
  }
  return sum / static_cast<double>(pictures.size() - 1);
}

/// The mean relative squared error against two references with errors of their own: E[(a - r)(a - s)] is that
/// of `a`, whatever the noise of r and s, since the three are independent.
inline double relative_mse(const Luminances& picture, const Luminances& r, const Luminances& s,
                           const std::vector<double>& weights) {
  double sum = 0.0;
  for (std::size_t i = 0; i < picture.size(); ++i)
    sum += weights[i] * (picture[i] - r[i]) * (picture[i] - s[i]);
  return sum;
}

}  // namespace vitrine
