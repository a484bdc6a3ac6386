// The tables of the box's config about what it does by itself: [idle] and [[dim]].
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "dim_schedule.h"
#include "idle_watch.h"
#include "strict_toml.h"

namespace vitrine {

/// The table `[idle]`: `after_s`, `every_s`, `reset_s`, `tour`. Throws InputError.
std::optional<IdleSettings> read_idle(const std::filesystem::path& path, const toml::table& root);
/// The tables `[[dim]]`: `from`, `to`, `level`. Throws InputError.
std::vector<DimSpan> read_dim(const std::filesystem::path& path, const toml::table& root);

}  // namespace vitrine
