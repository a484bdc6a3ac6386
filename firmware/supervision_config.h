// The tables of the box's config about its health: [governor] and [health].
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

#include "strict_toml.h"
#include "thermal_governor.h"

namespace vitrine {

struct GovernorSettings {
  ThermalLimits limits;
  std::optional<std::filesystem::path> thermal;    ///< nothing: the processor's zone, if the machine has one
  std::optional<std::filesystem::path> throttled;  ///< nothing: not looked at

  bool operator==(const GovernorSettings&) const = default;
};

struct HealthSettings {
  std::optional<std::filesystem::path>
      file;  ///< nothing: vitrine.prom in the runtime folder, if there is one
  std::chrono::milliseconds every{5'000};

  bool operator==(const HealthSettings&) const = default;
};

/// The table `[governor]`: `hot_c`, `cool_c`, `thermal_path`, `throttled_path`. Throws InputError.
std::optional<GovernorSettings> read_governor(const std::filesystem::path& path, const toml::table& root);
/// The table `[health]`: `file`, `every_s`. Throws InputError.
std::optional<HealthSettings> read_health(const std::filesystem::path& path, const toml::table& root);

}  // namespace vitrine
