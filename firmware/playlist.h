// The playlist: which scenes the box shows, in which order, under which titles.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "environment_choice.h"
#include "integrators/modes.h"

namespace vitrine {

struct PlaylistScene {
  std::string name;            ///< the file's name without folder and ending: what the command line calls it
  std::filesystem::path file;  ///< as it can be opened
  std::string title;
  std::string caption;                                     ///< a sentence for visitors; may be empty
  const Mode* mode = nullptr;                              ///< to begin with; nullptr: the one in use
  std::optional<EnvironmentChoice> environment{};          ///< instead of the one that the file brings
  std::optional<EnvironmentChoice> default_environment{};  ///< where the file brings no light at all

  bool operator==(const PlaylistScene&) const = default;
};

/// Reads a playlist: `[[scene]]` tables with `file` (relative to the playlist), `title`, and optionally
/// `caption`, `mode` and the keys of an environment. Scene files are not opened. Throws InputError.
std::vector<PlaylistScene> read_playlist(const std::filesystem::path& path);

/// Whether it has the ending of a scene: .gltf or .glb.
bool is_scene_file(const std::filesystem::path& path);
/// A scene that no playlist says anything about.
PlaylistScene scene_of_file(const std::filesystem::path& file);

/// The playlist that is installed, if there is one.
std::optional<std::filesystem::path> installed_playlist();

/// The scenes of `path`, or else of the installed playlist; none when that does not exist. Throws InputError.
std::vector<PlaylistScene> find_playlist(const std::optional<std::filesystem::path>& path);

/// What a SCENE argument means: a .gltf or .glb file, or the name of a scene of `playlist`. Throws InputError
/// with the names there are.
PlaylistScene resolve_scene(const std::string& argument, std::span<const PlaylistScene> playlist);

}  // namespace vitrine
