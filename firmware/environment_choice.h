// A picture of the surroundings that lights a scene: as the command line, a playlist or the box's config
// names it. Read when the scene is loaded.
#pragma once

#include <filesystem>
#include <optional>

#include <toml++/toml.h>

namespace vitrine {

struct EnvironmentChoice {
  std::filesystem::path file;  ///< equirectangular, Radiance .hdr
  double nits = 1000.0;        ///< that the picture's value 1 stands for
  double rotation_deg = 0.0;   ///< around the vertical; 0: the middle of the picture is +x, 90: -z

  bool operator==(const EnvironmentChoice&) const = default;
};

inline constexpr double kMaxEnvironmentNits = 1e9;
inline constexpr double kMaxEnvironmentRotation_deg = 360.0;

/// The keys `environment` (a file, relative to `path`), `environment_nits` and `environment_rotation` of
/// `table`; nothing without the first. Throws InputError.
std::optional<EnvironmentChoice> read_environment_choice(const std::filesystem::path& path,
                                                         const toml::table& table);

/// Throws InputError unless the file exists.
void require_environment(const EnvironmentChoice& choice);

}  // namespace vitrine
