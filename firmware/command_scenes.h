// `vitrine scenes`: the playlist as resolved.
#pragma once

#include <filesystem>
#include <optional>

namespace vitrine {

struct ScenesRequest {
  std::optional<std::filesystem::path> playlist;
  bool json = false;
};

int execute(const ScenesRequest& request);

}  // namespace vitrine
