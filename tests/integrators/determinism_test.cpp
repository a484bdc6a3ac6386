// One seed, one picture, bit for bit: however many threads trace it, whatever the size of a wave, by either
// driver, and however the picture is cut into tiles and ranges of samples. In fixed point the picture is also
// the same on every processor and by every compiler.
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "integrators/film_hash.h"
#include "integrators/ways.h"
#include "statistics/picture.h"

namespace vitrine {
namespace {

constexpr int kSize = 12;
constexpr std::uint32_t kSamples = 4;

struct Manner {
  Driver driver = Driver::kWave;
  int wave_size = 4096;
  unsigned threads = 1;
  int tile_width = kSize;
  int tile_height = kSize;
  std::uint32_t samples = kSamples;
  std::uint32_t range = kSamples;  ///< samples a call
  std::uint64_t seed = 1;
};

std::uint64_t render_hash(const BakedScene& scene, const SamplingParts& parts, const Manner& manner) {
  const auto renderer = scene.make_renderer({.mode = &modes().front(),
                                             .parts = parts,
                                             .width = kSize,
                                             .height = kSize,
                                             .seed = manner.seed,
                                             .driver = manner.driver,
                                             .wave_size = manner.wave_size});
  std::vector<Tile> tiles;
  for (int y = 0; y < kSize; y += manner.tile_height) {
    for (int x = 0; x < kSize; x += manner.tile_width) {
      tiles.push_back(
          {x, y, std::min(kSize, x + manner.tile_width), std::min(kSize, y + manner.tile_height)});
    }
  }
  Film film = renderer->make_film();
  const std::atomic<bool> cancel{false};
  for_each_on(manner.threads, static_cast<int>(tiles.size()), [&](int i) {
    for (std::uint32_t first = 0; first < manner.samples; first += manner.range) {
      renderer->trace(tiles[static_cast<std::size_t>(i)],
                      {first, std::min(manner.range, manner.samples - first)}, film, cancel);
    }
  });
  return film_hash(film);
}

/// Modes and parameters that differ in what they ask the driver for and in how they draw numbers.
std::vector<Way> telling_ways() {
  std::vector<Way> ways;
  for (const char* key : {"basic", "nee-all", "mis"}) ways.push_back({key, find_mode(key)->parts});
  for (const auto& [name, value] : {std::pair{"sequence", "grid"},
                                    {"sequence", "stratified"},
                                    {"sequence", "sobol"},
                                    {"sequence", "blue-noise"},
                                    {"radiance-samples", "3"},
                                    {"shadow-rays", "100"}}) {
    Way way{std::string(name) + ' ' + value, find_mode("mis")->parts};
    EXPECT_TRUE(find_parameter(name)->set(way.parts, value));
    ways.push_back(way);
  }
  return ways;
}

class Determinism : public testing::TestWithParam<Numbers> {
 protected:
  /// On a scene with diffuse surfaces, mirrors and glass and on one with lights of every kind.
  template <class Test>
  void for_each_scene_and_way(const Test& test) {
    for (const char* name : {"cornell-spheres", "gallery"}) {
      const auto scene = bake(project_scene(name), GetParam());
      for (const Way& way : telling_ways()) {
        SCOPED_TRACE(std::string(name) + ' ' + way.name);
        test(*scene, way.parts, render_hash(*scene, way.parts, {}));
      }
    }
  }
};

TEST_P(Determinism, AnyNumberOfThreads) {
  for_each_scene_and_way([](const BakedScene& scene, const SamplingParts& parts, std::uint64_t hash) {
    for (const unsigned threads : {1U, 2U, 7U}) {
      EXPECT_EQ(render_hash(scene, parts, {.threads = threads, .tile_width = 5, .tile_height = 3}), hash)
          << threads;
    }
  });
}

TEST_P(Determinism, AnyWaveSizeAndBothDrivers) {
  for_each_scene_and_way([](const BakedScene& scene, const SamplingParts& parts, std::uint64_t hash) {
    for (const int wave_size : {1, 7, 64, 4096}) {
      EXPECT_EQ(render_hash(scene, parts, {.wave_size = wave_size}), hash) << wave_size;
    }
    EXPECT_EQ(render_hash(scene, parts, {.driver = Driver::kPath}), hash);
  });
}

TEST_P(Determinism, AnyTilesAndRangesOfSamples) {
  for_each_scene_and_way([](const BakedScene& scene, const SamplingParts& parts, std::uint64_t hash) {
    EXPECT_EQ(render_hash(scene, parts, {.tile_width = 1, .tile_height = 16}), hash);
    EXPECT_EQ(render_hash(scene, parts, {.tile_width = 7, .tile_height = 5}), hash);
    for (const std::uint32_t range : {1U, 4U, 7U}) {
      EXPECT_EQ(render_hash(scene, parts, {.wave_size = 50, .range = range}), hash) << range;
    }
  });
}

TEST_P(Determinism, AnotherSeedIsAnotherPicture) {
  for_each_scene_and_way([](const BakedScene& scene, const SamplingParts& parts, std::uint64_t hash) {
    for (const std::uint64_t seed : {std::uint64_t{2}, std::uint64_t{1} << 32 | 1U}) {
      EXPECT_EQ(render_hash(scene, parts, {.seed = seed}) == hash, parts.sequence == Sequence::kGrid) << seed;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Numbers, Determinism, testing::Values(Numbers::kFloat, Numbers::kFixed),
                         [](const auto& test) { return std::string(numbers_name(test.param)); });

// If a change of the renderer is meant to change its pictures, the constants change with it; if not, it broke
// something.
TEST(FixedPoint, HasTheSamePictureEverywhere) {
  const std::map<std::string_view, std::uint64_t> golden{
      {"basic", 0x953cccf93527a019U},      {"basic-cosine", 0x58411307b87b97e0U},
      {"basic-brdf", 0x953cccf93527a019U}, {"basic-brdf-cosine", 0x58411307b87b97e0U},
      {"nee", 0xc34380858cee593dU},        {"nee-all", 0xc34380858cee593dU},
      {"nee-power", 0xc34380858cee593dU},  {"nee-tree", 0xc34380858cee593dU},
      {"mis", 0x3c553f703a48880U}};
  const auto scene = bake(project_scene("cornell"), Numbers::kFixed);
  for (const Mode& mode : modes()) {
    const std::uint64_t hash = render_hash(*scene, mode.parts, {.samples = 4});
    EXPECT_TRUE(golden.contains(mode.key) && golden.at(mode.key) == hash)
        << "{\"" << mode.key << "\", 0x" << std::hex << hash << "U},";
  }
}

}  // namespace
}  // namespace vitrine
