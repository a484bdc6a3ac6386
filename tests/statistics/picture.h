// A picture as statistics: rendered in batches of samples that are independent of each other, averaged over
// square tiles of pixels. The batches of a tile tell its mean and how well it is known.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frame/renderer.h"
#include "scene/gltf_import.h"
#include "source_file.h"
#include "statistics/all_cores.h"
#include "statistics/z_test.h"

namespace vitrine {

struct PictureOptions {
  int size = 32;  ///< pixels a side
  int tile = 4;   ///< pixels a side of a tile; divides size
  int batches = 32;
  std::uint32_t batch_samples = 16;  ///< a pixel
  std::uint64_t seed = 1;
  int max_depth = RenderOptions{}.max_depth;
  std::optional<SamplingParts> parts{};  ///< nothing: the mode's own
};

class TilePicture {
 public:
  TilePicture(int tiles, int batches)
      : tiles_(tiles),
        batches_(static_cast<std::size_t>(batches)),
        means_(static_cast<std::size_t>(tiles) * 3 * batches_) {}

  [[nodiscard]] int tiles() const { return tiles_; }
  /// Mean radiance in nits of channel `c` of a tile, a batch each.
  [[nodiscard]] std::span<double> batches(int tile, int c) {
    return {means_.data() + first(tile, c), batches_};
  }
  [[nodiscard]] std::span<const double> batches(int tile, int c) const {
    return {means_.data() + first(tile, c), batches_};
  }
  [[nodiscard]] Estimate estimate(int tile, int c) const { return vitrine::estimate(batches(tile, c)); }
  /// The whole picture's mean.
  [[nodiscard]] Estimate whole(int c) const {
    std::vector<double> sums(batches_);
    for (int tile = 0; tile < tiles_; ++tile) {
      for (std::size_t b = 0; b < batches_; ++b) sums[b] += batches(tile, c)[b] / tiles_;
    }
    return vitrine::estimate(sums);
  }

 private:
  [[nodiscard]] std::size_t first(int tile, int c) const {
    return (static_cast<std::size_t>(tile) * 3 + static_cast<std::size_t>(c)) * batches_;
  }

  int tiles_;
  std::size_t batches_;
  std::vector<double> means_;
};

/// Renders on all cores. The scene's first camera is used.
inline TilePicture render_tiles(const BakedScene& scene, const Mode& mode, const PictureOptions& options) {
  const int across = options.size / options.tile;
  TilePicture picture(across * across, options.batches);
  for_each_on_all_cores(options.batches, [&](int batch) {
    // A seed each: samples of one seed may depend on each other.
    const auto renderer = scene.make_renderer({.mode = &mode,
                                               .parts = options.parts,
                                               .width = options.size,
                                               .height = options.size,
                                               .seed = options.seed << 32 | static_cast<unsigned>(batch),
                                               .max_depth = options.max_depth});
    Film film = renderer->make_film();
    const std::atomic<bool> cancel{false};
    renderer->trace({0, 0, options.size, options.size}, {0, options.batch_samples}, film, cancel);
    for (int y = 0; y < options.size; ++y) {
      for (int x = 0; x < options.size; ++x) {
        const glm::dvec3 nits = film.mean_nits(x, y) / static_cast<double>(options.tile * options.tile);
        const int tile = y / options.tile * across + x / options.tile;
        for (int c = 0; c < 3; ++c) picture.batches(tile, c)[static_cast<std::size_t>(batch)] += nits[c];
      }
    }
  });
  return picture;
}

/// Whether a mode can find all light of a scene: lights without extent are never met by chance.
inline bool can_render(const Mode& mode, const Scene& scene) {
  return mode.parts.direct != DirectLight::kByChance || scene.lights.empty();
}

/// One of the project's own scenes, by its file's stem.
inline Scene project_scene(const std::string& name) {
  return import_gltf(source_file("scenes/" + name + ".gltf"));
}

}  // namespace vitrine
