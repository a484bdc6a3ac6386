// `vitrine render`: one picture of one scene, into a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparison.h"
#include "environment_choice.h"
#include "frame/renderer.h"
#include "frame/views.h"
#include "technique.h"

namespace vitrine {

/// One sample of one pixel, to be traced again.
struct SampleAddress {
  int x = 0;
  int y = 0;
  std::uint32_t sample = 0;
};

/// What the film's 64-bit sums hold of any scene.
inline constexpr std::uint32_t kMaxSpp = 1U << 20U;

struct RenderRequest {
  std::string scene;
  std::filesystem::path out;  ///< ends in .pfm or .png; unused with `replay`
  std::optional<std::filesystem::path> playlist;
  std::optional<EnvironmentChoice> environment;
  Numbers numbers = Numbers::kFloat;
  RenderOptions options;  ///< `camera` is set from `camera` below, what is traced from `techniques`
  std::vector<ParameterChange> changes;  ///< of parameters, as they were asked for
  std::vector<Technique> compare;        ///< two side by side, or none
  std::vector<Technique> techniques;     ///< what those come to: one, or two side by side
  Fairness fairness = Fairness::kEqualSamples;
  double split = 0.5;  ///< the part of the width that shows the first of two
  const View* view = &views().front();
  std::string camera = "0";
  std::uint32_t spp = 64;
  int threads = 0;  ///< 0: one a core
  double time_s = 0.0;
  std::optional<SampleAddress> replay;
  bool json = false;
};

int execute(const RenderRequest& request);

}  // namespace vitrine
