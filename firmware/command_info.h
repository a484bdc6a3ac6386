// `vitrine info`: what a scene file holds, and what of it vitrine ignores or approximates.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace vitrine {

struct InfoRequest {
  std::string scene;
  std::optional<std::filesystem::path> playlist;
  bool json = false;
};

int execute(const InfoRequest& request);

}  // namespace vitrine
