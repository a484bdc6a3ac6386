#include "supervision_config.h"

#include "toml_reader.h"

namespace vitrine {

std::optional<GovernorSettings> read_governor(const std::filesystem::path& path, const toml::table& root) {
  const toml::table* table = optional_table(path, root, "governor");
  if (table == nullptr) return std::nullopt;
  const TomlReader reader(path, *table, {"hot_c", "cool_c", "thermal_path", "throttled_path"});
  GovernorSettings governor;
  if (const auto hot = reader.number("hot_c", 20.0, 150.0)) governor.limits.hot_c = *hot;
  if (const auto cool = reader.number("cool_c", 10.0, 149.0)) governor.limits.cool_c = *cool;
  if (governor.limits.cool_c >= governor.limits.hot_c) {
    throw reader.error(reader.has("cool_c") ? "cool_c" : "hot_c", "cool_c is not below hot_c",
                       "leave some degrees between the two, or it would swing");
  }
  governor.thermal = reader.file("thermal_path");
  governor.throttled = reader.file("throttled_path");
  return governor;
}

std::optional<HealthSettings> read_health(const std::filesystem::path& path, const toml::table& root) {
  const toml::table* table = optional_table(path, root, "health");
  if (table == nullptr) return std::nullopt;
  const TomlReader reader(path, *table, {"file", "every_s"});
  HealthSettings health;
  health.file = reader.file("file");
  if (const auto every = reader.seconds("every_s", 0.5, 3600.0)) health.every = *every;
  return health;
}

}  // namespace vitrine
