// Four scenes against converged pictures by an independent renderer: the mean of every channel, which shows a
// missing bounce, and the means of 16x16 blocks, which show local bias under the noise. The pictures are not
// part of the project; they are looked for in the folder that the environment variable VITRINE_SHARED names.
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
#include "statistics/picture.h"

namespace vitrine {
namespace {

constexpr int kBlock = 16;
constexpr double kDark = 0.02;  // of the picture's mean: blocks below it do not count

std::filesystem::path shared_folder() {
  if (const char* folder = std::getenv("VITRINE_SHARED")) return folder;
  return std::filesystem::path(VITRINE_SOURCE_DIR) / ".." / "shared";
}

struct Comparison {
  glm::dvec3 mean_ratio;
  double block_rms;
};

Comparison compare(const Film& film, const Pfm& reference) {
  glm::dvec3 mean(0.0);
  glm::dvec3 reference_mean(0.0);
  const int across = film.width() / kBlock;
  const int blocks = across * (film.height() / kBlock);
  std::vector<glm::dvec3> block(static_cast<std::size_t>(blocks), glm::dvec3(0.0));
  std::vector<glm::dvec3> reference_block = block;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const auto b = static_cast<std::size_t>(y / kBlock * across + x / kBlock);
      block[b] += film.mean_nits(x, y);
      reference_block[b] += glm::dvec3(reference.at(x, y));
      mean += film.mean_nits(x, y);
      reference_mean += glm::dvec3(reference.at(x, y));
    }
  }
  const double dark = kDark * (reference_mean.x + reference_mean.y + reference_mean.z) / (3.0 * blocks);
  double squares = 0.0;
  int counted = 0;
  for (std::size_t b = 0; b < block.size(); ++b) {
    for (int c = 0; c < 3; ++c) {
      if (!(reference_block[b][c] > dark)) continue;
      const double deviation = block[b][c] / reference_block[b][c] - 1.0;
      squares += deviation * deviation;
      ++counted;
    }
  }
  return {mean / reference_mean, std::sqrt(squares / counted)};
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
  const Scene scene = import_gltf(file);
  const Mode& mode = *find_mode(key);
  const Pfm reference = read_pfm(picture);
  const auto baked = bake(scene, numbers);
  const auto renderer =
      baked->make_renderer({.mode = &mode, .width = reference.width, .height = reference.height, .seed = 1});
  Film film = renderer->make_film();
  const std::atomic<bool> cancel{false};
  for_each_on_all_cores(reference.height, [&](int y) {
    renderer->trace({0, y, reference.width, y + 1}, {0, GetParam().samples}, film, cancel);
  });
  const Comparison found = compare(film, reference);
  std::cout << "  mean ratio " << found.mean_ratio.x << ' ' << found.mean_ratio.y << ' ' << found.mean_ratio.z
            << ", block rms " << found.block_rms << " at " << samples << " samples\n";
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found.mean_ratio[c], 1.0, 0.005) << "channel " << c;
  EXPECT_LE(found.block_rms, 0.02);
}

// By chance alone the noise of a block needs more samples; in fixed point, and for every distribution of
// directions, that takes too long even for a slow test. That those agree with the others is shown elsewhere.
std::vector<Case> cases() {
  struct Row {
    const char* scene;
    std::uint32_t samples_by_chance;  ///< 0: a light without extent is never met
  };
  std::vector<Case> all;
  for (const auto& [scene, by_chance] :
       {Row{"cornell", 4096}, Row{"furnace", 256}, Row{"quadlight", 2048}, Row{"pointplane", 0}}) {
    for (const Numbers numbers : {Numbers::kFloat, Numbers::kFixed}) {
      for (const Mode& mode : modes()) {
        const bool chance = mode.parts.direct == DirectLight::kByChance;
        if (chance && (numbers == Numbers::kFixed || by_chance == 0 || mode.key != "basic")) continue;
        all.push_back({scene, numbers, std::string(mode.key), chance ? by_chance : 256});
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
