// A scene without light transport: its renderer fills tiles with one value, or works on until it is
// cancelled. What the kiosk does with renderers is tested with it.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>

#include "loaded_scene.h"

namespace vitrine {

/// What the fake renderers of a test do, and what was done to them.
struct FakeWorld {
  std::atomic<bool> endless{false};  ///< trace() ends by being cancelled only
  std::atomic<bool> deaf{false};     ///< and does not notice that yet
  std::atomic<int> tracing{0};       ///< calls of trace() under way
  std::atomic<int> cancelled{0};     ///< calls that were
  std::atomic<bool> broken{false};   ///< trace() throws
};

/// The grey that a fake picture of this mode shows.
inline std::uint8_t fake_grey(const Mode& mode) {
  return static_cast<std::uint8_t>(100 + 10 * (&mode - modes().data()));
}

/// The rays that a fake sample of this mode costs.
inline std::uint64_t fake_cost(const Mode& mode) { return mode.key == "basic" ? 1 : 3; }

class FakeRenderer final : public Renderer {
 public:
  FakeRenderer(FakeWorld& world, const RenderOptions& options) : world_(world), options_(options) {}

  [[nodiscard]] Film make_film() const override { return {options_.width, options_.height, 0}; }
  TraceStats trace(const Tile& tile, SampleRange samples, Film& film,
                   const std::atomic<bool>& cancel) const override {
    TraceStats stats;
    ++world_.tracing;
    while (world_.endless && (!cancel || world_.deaf)) std::this_thread::yield();
    --world_.tracing;
    if (world_.broken) throw std::runtime_error("the renderer broke");
    if (cancel) {
      ++world_.cancelled;
      stats.cancelled = true;
      return stats;
    }
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        for (std::uint32_t i = 0; i < samples.count; ++i) film.add(x, y, FilmValue(1));
      }
    }
    stats.samples = static_cast<std::uint64_t>(tile.width() * tile.height()) * samples.count;
    stats.rays = stats.samples * fake_cost(*options_.mode);
    return stats;
  }
  [[nodiscard]] Exposure meter(const Film&) const override { return {.quarter_stops = 4}; }
  void develop(const Film& film, const Tile& tile, Exposure, std::uint8_t* rgb) const override {
    for (int y = tile.y0; y < tile.y1; ++y) {
      std::uint8_t* row = rgb + 3 * (y * film.width() + tile.x0);
      std::fill(row, row + static_cast<std::ptrdiff_t>(tile.width()) * 3, fake_grey(*options_.mode));
    }
  }

 private:
  FakeWorld& world_;
  RenderOptions options_;
};

class FakeBakedScene final : public BakedScene {
 public:
  explicit FakeBakedScene(FakeWorld& world) : world_(world) {}

  [[nodiscard]] std::unique_ptr<Renderer> make_renderer(const RenderOptions& options) const override {
    return std::make_unique<FakeRenderer>(world_, options);
  }
  [[nodiscard]] std::size_t triangle_count() const override { return 0; }
  [[nodiscard]] std::size_t light_count() const override { return 0; }

 private:
  FakeWorld& world_;
};

inline std::shared_ptr<const LoadedScene> fake_scene(FakeWorld& world) {
  auto loaded = std::make_shared<LoadedScene>();
  loaded->cameras = {"camera"};
  loaded->baked = std::make_unique<FakeBakedScene>(world);
  return loaded;
}

/// Loads every scene as a fake one.
inline LoadScene fake_loader(FakeWorld& world) {
  return [&world](const PlaylistScene&, Numbers) { return fake_scene(world); };
}

inline PlaylistScene named_scene(const std::string& name) {
  return {.name = name, .file = name + ".gltf", .title = "The " + name, .caption = "", .mode = nullptr};
}

}  // namespace vitrine
