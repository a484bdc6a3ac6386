// Measures the lecture's claims and prints them as a table: how many times less variance at equal samples,
// and how many times less squared error at equal time, on one thread. A claim that does not hold is marked,
// not hidden.
//
//   lecture_claims [--size N] [--seconds S] [--rounds N]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "claims/claims.h"
#include "claims/measure.h"

namespace vitrine {
namespace {

struct Settings {
  int size = 64;         ///< pixels a side
  double seconds = 1.0;  ///< of each picture at equal time
  int rounds = 5;        ///< of which the median counts
};

/// What the claims about one scene share.
struct Ground {
  Scene scene;
  std::unique_ptr<const BakedScene> baked;
  Luminances reference;  ///< two, of different seeds
  Luminances other_reference;
};

Ground make_ground(const std::string& name, const Settings& settings) {
  Ground ground{project_scene(name), nullptr, {}, {}};
  ground.baked = bake(ground.scene, Numbers::kFloat);
  const SamplingParts best = sampling("mis sequence=sobol");
  constexpr std::uint32_t kSamples = 2048;
  constexpr int kSeeds = 4;
  const auto pictures = render_seeds(*ground.baked, best, settings.size, kSamples, 1'000'000, 2 * kSeeds);
  ground.reference = mean_picture({pictures.begin(), pictures.begin() + kSeeds});
  ground.other_reference = mean_picture({pictures.begin() + kSeeds, pictures.end()});
  return ground;
}

/// As many samples as fit into the time, a power of two at a time, each time counted.
Luminances render_for(const BakedScene& scene, const SamplingParts& parts, const Settings& settings,
                      std::uint64_t seed) {
  using Clock = std::chrono::steady_clock;
  const auto renderer = scene.make_renderer({.mode = &modes().front(),
                                             .parts = parts,
                                             .width = settings.size,
                                             .height = settings.size,
                                             .seed = seed});
  Film film = renderer->make_film();
  const std::atomic<bool> cancel{false};
  const Clock::time_point began = Clock::now();
  double elapsed = 0.0;
  for (std::uint32_t done = 0; elapsed < settings.seconds;) {
    // No pass that would take the time far beyond its end.
    const double pace = done == 0 ? 0.0 : elapsed / done;
    std::uint32_t samples = std::max(1U, done);
    while (samples > 1 && elapsed + samples * pace > 1.02 * settings.seconds) samples /= 2;
    renderer->trace({0, 0, settings.size, settings.size}, {done, samples}, film, cancel);
    done += samples;
    elapsed = std::chrono::duration<double>(Clock::now() - began).count();
  }
  return luminances(film);
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

struct Measured {
  double variance_ratio;  ///< worse / better
  double mse_ratio;
};

Measured measure(const Claim& claim, const Ground& ground, const Settings& settings) {
  const SamplingParts better = sampling(claim.better);
  const SamplingParts worse = sampling(claim.worse);
  const auto pixels = static_cast<std::size_t>(settings.size) * static_cast<std::size_t>(settings.size);
  const Mask mask =
      claim.material.empty() ? Mask(pixels, true) : see_material(ground.scene, claim.material, settings.size);
  const std::vector<double> weights =
      pixel_weights(mean_picture({ground.reference, ground.other_reference}), mask);
  const auto variance = [&](const SamplingParts& parts, std::uint64_t seed) {
    return relative_variance(render_seeds(*ground.baked, parts, settings.size, 16, seed, 16), weights);
  };
  std::vector<double> ratios;
  for (int round = 0; round < settings.rounds; ++round) {
    const auto error = [&](const SamplingParts& parts, std::uint64_t seed) {
      return relative_mse(
          render_for(*ground.baked, parts, settings, seed + static_cast<std::uint64_t>(round)),
          ground.reference, ground.other_reference, weights);
    };
    const double of_better = error(better, 100);
    ratios.push_back(error(worse, 200) / of_better);
  }
  return {variance(worse, 300) / variance(better, 400), median(ratios)};
}

int run(const Settings& settings) {
  std::printf("| claim | scene | better | worse | variance at equal samples | error at equal time |\n");
  std::printf("|---|---|---|---|---|---|\n");
  std::map<std::string, Ground> grounds;
  int broken = 0;
  for (const Claim& claim : claims()) {
    const std::string name(claim.scene);
    if (!grounds.contains(name)) grounds.emplace(name, make_ground(name, settings));
    const Measured measured = measure(claim, grounds.at(name), settings);
    const auto mark = [&](double ratio) { return ratio * claim.at_most < 1.0 ? " **not so**" : ""; };
    if (measured.variance_ratio * claim.at_most < 1.0) ++broken;
    std::printf("| %s | %s | `%s` | `%s` | %.3g x less%s | %.3g x less%s |\n",
                std::string(claim.section).c_str(), name.c_str(), std::string(claim.better).c_str(),
                std::string(claim.worse).c_str(), measured.variance_ratio, mark(measured.variance_ratio),
                measured.mse_ratio, mark(measured.mse_ratio));
    std::fflush(stdout);
  }
  std::printf(
      "\n%dx%d pixels; variance of 16 pictures of 16 samples a pixel; error: median of %d rounds of %g s.\n",
      settings.size, settings.size, settings.rounds, settings.seconds);
  if (broken > 0) std::printf("%d of %zu claims do not hold at equal samples.\n", broken, claims().size());
  return broken == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

int usage() {
  std::fprintf(stderr, "lecture_claims: use [--size N] [--seconds S] [--rounds N], each above 0\n");
  return 2;
}

}  // namespace
}  // namespace vitrine

int main(int argc, char** argv) {
  vitrine::Settings settings;
  for (int i = 1; i < argc; i += 2) {
    const std::string option = argv[i];
    const double value = i + 1 < argc ? std::atof(argv[i + 1]) : 0.0;
    if (!(value > 0.0)) return vitrine::usage();
    if (option == "--size") {
      settings.size = static_cast<int>(value);
    } else if (option == "--seconds") {
      settings.seconds = value;
    } else if (option == "--rounds") {
      settings.rounds = static_cast<int>(value);
    } else {
      return vitrine::usage();
    }
  }
  return vitrine::run(settings);
}
