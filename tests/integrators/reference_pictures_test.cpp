// Four scenes against converged pictures by an independent renderer: the mean of every channel, which shows a
// missing bounce, and the means of 16x16 blocks, which show local bias. Two pictures a and b of different
// seeds are taken, since E[(a - r)(b - r)] over blocks is their squared bias, whatever their noise. The
// references r are not part of the project; they are looked for in the folder that the environment variable
// VITRINE_SHARED names.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "film/pfm.h"
#include "integrators/ways.h"
#include "source_file.h"
#include "statistics/picture.h"

namespace vitrine {
namespace {

constexpr int kBlock = 16;
constexpr double kDark = 0.02;  // of the picture's mean: blocks below it do not count

std::filesystem::path shared_folder() {
  if (const char* folder = std::getenv("VITRINE_SHARED")) return folder;
  return source_file("../shared");
}

/// The means of the blocks, row by row, and their mean.
struct Blocks {
  std::vector<glm::dvec3> means;
  glm::dvec3 mean = glm::dvec3(0.0);
};

template <class PixelAt>
Blocks blocks_of(int width, int height, const PixelAt& pixel_at) {
  const int across = width / kBlock;
  const int count = across * (height / kBlock);
  Blocks blocks{std::vector(static_cast<std::size_t>(count), glm::dvec3(0.0))};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::dvec3 share = pixel_at(x, y) / static_cast<double>(kBlock * kBlock);
      blocks.means[static_cast<std::size_t>(y / kBlock * across + x / kBlock)] += share;
      blocks.mean += share / static_cast<double>(count);
    }
  }
  return blocks;
}

struct Comparison {
  glm::dvec3 mean_ratio;
  double block_bias;  ///< root mean square, relative
};

Comparison compare(const Blocks& a, const Blocks& b, const Blocks& reference) {
  const double dark = kDark * (reference.mean.x + reference.mean.y + reference.mean.z) / 3.0;
  double squares = 0.0;
  int counted = 0;
  for (std::size_t i = 0; i < reference.means.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double r = reference.means[i][c];
      if (!(r > dark)) continue;
      squares += (a.means[i][c] / r - 1.0) * (b.means[i][c] / r - 1.0);
      ++counted;
    }
  }
  return {(a.mean + b.mean) / (2.0 * reference.mean), std::sqrt(std::max(0.0, squares / counted))};
}

struct Case {
  std::string scene;
  Numbers numbers;
  std::string mode;
  std::uint32_t samples;
};

class ReferencePictures : public testing::TestWithParam<Case> {};

TEST_P(ReferencePictures, AreMatched) {
  const auto& [name, numbers, key, samples] = GetParam();
  const std::filesystem::path file = shared_folder() / "scenes" / (name + ".gltf");
  const std::filesystem::path picture = shared_folder() / "references" / (name + ".pfm");
  if (!std::filesystem::exists(file) || !std::filesystem::exists(picture)) {
    GTEST_SKIP() << "no " << file << " or no " << picture
                 << "; set VITRINE_SHARED to the folder that has them";
  }
  const Mode* const mode = find_mode(key);
  const Pfm reference = read_pfm(picture);
  const auto baked = bake(import_gltf(file), numbers);
  const auto render = [&](std::uint64_t seed) {
    const auto renderer = baked->make_renderer(
        {.mode = mode, .width = reference.width, .height = reference.height, .seed = seed});
    Film film = renderer->make_film();
    const std::atomic<bool> cancel{false};
    for_each_on_all_cores(reference.height, [&](int y) {
      renderer->trace({0, y, reference.width, y + 1}, {0, GetParam().samples / 2}, film, cancel);
    });
    return blocks_of(film.width(), film.height(), [&](int x, int y) { return film.mean_nits(x, y); });
  };
  const Comparison found = compare(render(1), render(2),
                                   blocks_of(reference.width, reference.height,
                                             [&](int x, int y) { return glm::dvec3(reference.at(x, y)); }));
  std::cout << "  mean ratio " << found.mean_ratio.x << ' ' << found.mean_ratio.y << ' ' << found.mean_ratio.z
            << ", block bias " << found.block_bias << " at " << samples << " samples\n";
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found.mean_ratio[c], 1.0, 0.005) << "channel " << c;
  EXPECT_LE(found.block_bias, 0.02);
}

// By chance alone a picture needs more samples; in fixed point, and for every distribution of directions,
// that takes too long even for a slow test. That those agree with the others is shown elsewhere.
std::vector<Case> cases() {
  struct Row {
    const char* scene;
    std::uint32_t samples_by_chance;  ///< 0: a light without extent is never met
  };
  std::vector<Case> all;
  for (const auto& [scene, by_chance] :
       {Row{"cornell", 2048}, Row{"furnace", 64}, Row{"quadlight", 1024}, Row{"pointplane", 0}}) {
    for (const Numbers numbers : {Numbers::kFloat, Numbers::kFixed}) {
      for (const Mode& mode : modes()) {
        const bool chance = mode.parts.direct == DirectLight::kByChance;
        if (chance && (numbers == Numbers::kFixed || by_chance == 0 || mode.key != "basic")) continue;
        all.push_back({scene, numbers, std::string(mode.key), chance ? by_chance : 64});
      }
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ReferencePictures, testing::ValuesIn(cases()), [](const auto& test) {
  return test_name(test.param.scene + '_' + std::string(numbers_name(test.param.numbers)) + '_' +
                   test.param.mode);
});

}  // namespace
}  // namespace vitrine
