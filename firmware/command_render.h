// `vitrine render`: one picture of one scene, into a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "frame/renderer.h"

namespace vitrine {

/// One sample of one pixel, to be traced again.
struct SampleAddress {
  int x = 0;
  int y = 0;
  std::uint32_t sample = 0;
};

struct RenderRequest {
  std::string scene;
  std::filesystem::path out;  ///< ends in .pfm or .png; unused with `replay`
  std::optional<std::filesystem::path> playlist;
  Numbers numbers = Numbers::kFloat;
  RenderOptions options;  ///< `camera` is set from `camera` below
  std::string camera = "0";
  std::uint32_t spp = 64;
  int threads = 0;  ///< 0: one a core
  double time_s = 0.0;
  std::optional<SampleAddress> replay;
  bool json = false;
};

int execute(const RenderRequest& request);

}  // namespace vitrine
