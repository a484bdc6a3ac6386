// The playlist: which scenes the box shows, in which order, under which titles.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "integrators/modes.h"

namespace vitrine {

struct PlaylistScene {
  std::string name;            ///< the file's name without folder and ending: what the command line calls it
  std::filesystem::path file;  ///< as it can be opened
  std::string title;
  std::string caption;         ///< a sentence for visitors; may be empty
  const Mode* mode = nullptr;  ///< to begin with; nullptr: the one in use
};

/// Reads a playlist: `[[scene]]` tables with `file` (relative to the playlist), `title`, and optionally
/// `caption` and `mode`. Scene files are not opened. Throws InputError.
std::vector<PlaylistScene> read_playlist(const std::filesystem::path& path);

/// The playlist that is installed with the program (or lies beside it in a build folder), if there is one.
std::optional<std::filesystem::path> installed_playlist();

/// The scenes of `path`, or else of the installed playlist; none when that does not exist. Throws InputError.
std::vector<PlaylistScene> find_playlist(const std::optional<std::filesystem::path>& path);

/// What a SCENE argument means: a .gltf or .glb file, or the name of a scene of `playlist`. Throws InputError
/// with the names there are.
PlaylistScene resolve_scene(const std::string& argument, std::span<const PlaylistScene> playlist);

}  // namespace vitrine
