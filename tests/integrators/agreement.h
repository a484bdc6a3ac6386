// Do several renderings of a scene show the same picture? Their means are compared with those of a reference,
// and float with fixed point, tile by tile (Welch's test, corrected for the number of comparisons).
//
// Rare and bright finds (a small lamp that is met by chance, a highlight, a caustic) make the mean of a small
// tile low and its variance too small. So each picture is cut into the smallest tiles of which none is ruled
// by a single batch: the tiles then hold enough of those finds for their variance to be known, and the test
// takes their skewness into account. Where even the whole picture is ruled by a batch, its mean may be low
// for want of luck, but not high. Which tiles were compared is printed.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "integrators/ways.h"
#include "source_file.h"
#include "statistics/picture.h"

namespace vitrine {

inline constexpr std::uint32_t kMoreByChance =
    4;  // times as many samples for a mode without shadow rays: they are cheaper

/// Above this share of the squared deviations a batch rules; the largest of 64 normal ones has about 0.1.
inline constexpr double kRulingShare = 0.5;

/// What float arithmetic may differ by, where a way has no variance.
inline constexpr double kRounding = 1e-5;

inline bool is_ruled(const TilePicture& picture) {
  for (int tile = 0; tile < picture.tiles(); ++tile) {
    for (int c = 0; c < 3; ++c) {
      const auto batches = picture.batches(tile, c);
      const Estimate mean = estimate(batches);
      const double squares = mean.variance * static_cast<double>(batches.size()) * mean.freedom;
      for (const double x : batches) {
        if ((x - mean.mean) * (x - mean.mean) > kRulingShare * squares) return true;
      }
    }
  }
  return false;
}

/// Tiles of twice the side.
inline TilePicture coarser(const TilePicture& picture, int across) {
  TilePicture coarse(picture.tiles() / 4, static_cast<int>(picture.batches(0, 0).size()));
  for (int tile = 0; tile < picture.tiles(); ++tile) {
    const int parent = tile / across / 2 * (across / 2) + tile % across / 2;
    for (int c = 0; c < 3; ++c) {
      const auto from = picture.batches(tile, c);
      const auto to = coarse.batches(parent, c);
      for (std::size_t b = 0; b < from.size(); ++b) to[b] += from[b] / 4;
    }
  }
  return coarse;
}

struct Rendering {
  std::string name;
  std::vector<TilePicture> cuts;  ///< from the finest to the whole picture
  std::size_t finest_fit = 0;     ///< the first cut without a ruled tile; cuts.size(): none
};

inline Rendering render_cuts(const BakedScene& scene, Numbers numbers, const Way& way,
                             PictureOptions options) {
  if (!sends_shadow_rays(way.parts)) options.batch_samples *= kMoreByChance;
  options.parts = way.parts;
  Rendering rendering{.name = std::string(numbers_name(numbers)) + ' ' + way.name,
                      .cuts = {render_tiles(scene, modes().front(), options)},
                      .finest_fit = 0};
  for (int across = options.size / options.tile; across > 1; across /= 2) {
    rendering.cuts.push_back(coarser(rendering.cuts.back(), across));
  }
  while (rendering.finest_fit < rendering.cuts.size() && is_ruled(rendering.cuts[rendering.finest_fit])) {
    ++rendering.finest_fit;
  }
  return rendering;
}

/// Compares at the finest cut that is fit in both.
inline void expect_same(const Rendering& a, const Rendering& b, std::size_t pairs) {
  SCOPED_TRACE(a.name + " against " + b.name);
  const std::size_t fit = std::max(a.finest_fit, b.finest_fit);
  const std::size_t cut = std::min(fit, a.cuts.size() - 1);
  const TilePicture& p = a.cuts[cut];
  const TilePicture& q = b.cuts[cut];
  const double limit = sidak_limit(pairs * static_cast<std::size_t>(p.tiles()) * 3);
  const bool a_may_be_low = a.finest_fit > cut;
  const bool b_may_be_low = b.finest_fit > cut;
  double worst = 0.0;
  for (int tile = 0; tile < p.tiles(); ++tile) {
    for (int c = 0; c < 3; ++c) {
      const Estimate one = p.estimate(tile, c);
      const double z = z_score(one, q.estimate(tile, c), kRounding * one.mean);
      worst = std::max(worst, std::abs(z));
      EXPECT_TRUE(z > -limit || a_may_be_low) << "tile " << tile << " channel " << c << ": z = " << z;
      EXPECT_TRUE(z < limit || b_may_be_low) << "tile " << tile << " channel " << c << ": z = " << z;
    }
  }
  std::cout << "  " << a.name << " | " << b.name << ": " << p.tiles() << " tiles, |z| <= " << worst << " of "
            << limit << (a_may_be_low ? ", the first may be low" : "")
            << (b_may_be_low ? ", the second may be low" : "") << '\n';
}

/// What a scene looks like by every way that can render it, in both number systems, each with a seed of its
/// own; and a reference with more samples.
struct Agreement {
  Rendering reference;
  std::vector<std::array<Rendering, 2>> ways;  ///< in float, in fixed point
};

inline Agreement render_all(const Scene& scene, std::vector<Way> ways, PictureOptions options) {
  constexpr std::uint32_t kReferenceSamples = 4;  // times as many
  options.batches = 64;
  options.seed = 1;
  std::erase_if(ways, [&](const Way& way) { return !sends_shadow_rays(way.parts) && !scene.lights.empty(); });
  const std::array baked{bake(scene, Numbers::kFloat), bake(scene, Numbers::kFixed)};
  PictureOptions thorough = options;
  thorough.batch_samples *= kReferenceSamples;
  const Way best{"reference", find_mode("mis")->parts};
  Agreement agreement{render_cuts(*baked[0], Numbers::kFloat, best, thorough), {}};
  for (const Way& way : ways) {
    const auto rendering = [&](Numbers numbers) {
      ++options.seed;
      return render_cuts(*baked[numbers == Numbers::kFloat ? 0 : 1], numbers, way, options);
    };
    Rendering in_float = rendering(Numbers::kFloat);
    agreement.ways.push_back({std::move(in_float), rendering(Numbers::kFixed)});
  }
  return agreement;
}

/// Every way against the reference, and each in float against itself in fixed point.
inline void expect_all_same(const Agreement& agreement) {
  ASSERT_FALSE(agreement.ways.empty());
  const std::size_t pairs = 3 * agreement.ways.size();
  for (const auto& [in_float, in_fixed] : agreement.ways) {
    expect_same(in_float, agreement.reference, pairs);
    expect_same(in_fixed, agreement.reference, pairs);
    expect_same(in_fixed, in_float, pairs);
  }
}

/// Without those that find the small lamps in the smooth plates so rarely that no number of samples here
/// tells a low mean from a wrong one: ModesAgreeWhenSoftened is about them.
inline std::vector<Way> judgeable(std::vector<Way> ways, const std::string& scene) {
  if (scene != "plates") return ways;
  std::erase_if(ways, [&](const Way& way) {
    const bool blind = !sends_shadow_rays(way.parts) && (way.parts.direction == DirectionSampling::kUniform ||
                                                         way.parts.direction == DirectionSampling::kCosine);
    if (blind) std::cout << "  " << way.name << ": not judged on " << scene << '\n';
    return blind;
  });
  return ways;
}

/// Every scene of the project.
inline std::vector<std::string> project_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(source_file("scenes"))) {
    if (entry.path().extension() == ".gltf") names.push_back(entry.path().stem());
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace vitrine
