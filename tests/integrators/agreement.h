// Do several renderings of a scene show the same picture? Their means are compared pair by pair, tile by
// tile.
//
// Rare and bright finds (a small lamp that is met by chance, a highlight, a caustic) make the mean of a small
// tile low and its variance too small. So each picture is cut into the smallest tiles of which none is ruled
// by a single batch: the tiles then hold enough of those finds for their variance to be known, and the test
// takes their skewness into account. Where even the whole picture is ruled by a batch, its mean may be low
// for want of luck, but not high. Which tiles were compared is printed.
#pragma once

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "statistics/picture.h"

namespace vitrine {

inline constexpr std::uint32_t kMoreByChance =
    4;  // times as many samples for a mode without shadow rays: they are cheaper

/// Above this share of the squared deviations a batch rules; the largest of 64 normal ones has about 0.1.
inline constexpr double kRulingShare = 0.5;

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

inline Rendering render_cuts(const BakedScene& scene, Numbers numbers, const Mode& mode,
                             PictureOptions options) {
  if (mode.direct == DirectLight::kByChance) options.batch_samples *= kMoreByChance;
  Rendering rendering{.name = std::string(numbers_name(numbers)) + ' ' + std::string(mode.key),
                      .cuts = {render_tiles(scene, mode, options)},
                      .finest_fit = 0};
  for (int across = options.size / options.tile; across > 1; across /= 2) {
    rendering.cuts.push_back(coarser(rendering.cuts.back(), across));
  }
  while (rendering.finest_fit < rendering.cuts.size() && is_ruled(rendering.cuts[rendering.finest_fit])) {
    ++rendering.finest_fit;
  }
  return rendering;
}

/// By every mode that can render it and in both number systems, each with a seed of its own.
inline std::vector<Rendering> render_all_ways(const Scene& scene, PictureOptions options) {
  options.batches = 64;
  std::vector<Rendering> renderings;
  for (const Numbers numbers : {Numbers::kFloat, Numbers::kFixed}) {
    const auto baked = bake(scene, numbers);
    for (const Mode& mode : modes()) {
      if (!can_render(mode, scene)) continue;
      options.seed = renderings.size() + 1;
      renderings.push_back(render_cuts(*baked, numbers, mode, options));
    }
  }
  return renderings;
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
      const double z = z_score(p.estimate(tile, c), q.estimate(tile, c));
      worst = std::max(worst, std::abs(z));
      EXPECT_TRUE(z > -limit || a_may_be_low) << "tile " << tile << " channel " << c << ": z = " << z;
      EXPECT_TRUE(z < limit || b_may_be_low) << "tile " << tile << " channel " << c << ": z = " << z;
    }
  }
  std::cout << "  " << a.name << " | " << b.name << ": " << p.tiles() << " tiles, |z| <= " << worst << " of "
            << limit << (a_may_be_low ? ", the first may be low" : "")
            << (b_may_be_low ? ", the second may be low" : "") << '\n';
}

inline void expect_all_same(const std::vector<Rendering>& renderings) {
  ASSERT_GE(renderings.size(), 4U);
  const std::size_t pairs = renderings.size() * (renderings.size() - 1) / 2;
  for (std::size_t i = 0; i < renderings.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) expect_same(renderings[i], renderings[j], pairs);
  }
}

/// Every scene of the project.
inline std::vector<std::string> project_scenes() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(VITRINE_SOURCE_DIR) / "scenes")) {
    if (entry.path().extension() == ".gltf") names.push_back(entry.path().stem());
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace vitrine
