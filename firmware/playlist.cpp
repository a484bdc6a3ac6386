#include "playlist.h"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "installed_files.h"
#include "mode_choice.h"
#include "nearest_name.h"
#include "scene/input_error.h"
#include "strict_toml.h"

namespace vitrine {
namespace {

PlaylistScene read_scene(const std::filesystem::path& path, const toml::table& table) {
  require_known_keys(
      path, table,
      {"file", "title", "caption", "mode", "environment", "environment_nits", "environment_rotation"});
  const auto text = [&](const std::string& key) {
    return toml_value<std::string>(path, table, key, "a string");
  };

  const std::optional<std::string> file = text("file");
  if (!file || file->empty()) {
    throw toml_error(path, table.source(), "this scene has no file", "add file = \"NAME.gltf\"");
  }
  PlaylistScene scene;
  scene.file = path.parent_path() / *file;
  scene.name = scene.file.stem().string();
  scene.title = text("title").value_or(scene.name);
  scene.caption = text("caption").value_or("");
  scene.environment = read_environment_choice(path, table);
  if (const std::optional<std::string> key = text("mode")) {
    scene.mode = find_mode(*key);
    if (scene.mode == nullptr) {
      throw toml_error(path, table.get("mode")->source(), "no mode '" + *key + "'",
                       name_remedy(*key, mode_keys()));
    }
  }
  return scene;
}

}  // namespace

bool is_scene_file(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending == ".gltf" || ending == ".glb";
}

PlaylistScene scene_of_file(const std::filesystem::path& file) {
  const std::string name = file.stem().string();
  return {.name = name, .file = file, .title = name, .caption = "", .mode = nullptr};
}

std::vector<PlaylistScene> read_playlist(const std::filesystem::path& path) {
  const toml::table root = read_toml(path);
  std::vector<PlaylistScene> scenes;
  for (const toml::table* table : toml_tables(path, root, "scene", "file and title")) {
    PlaylistScene scene = read_scene(path, *table);
    if (std::ranges::find(scenes, scene.name, &PlaylistScene::name) != scenes.end()) {
      throw toml_error(path, table->source(), "a second scene '" + scene.name + "'",
                       "give its file another name");
    }
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

std::optional<std::filesystem::path> installed_playlist() { return installed_file("scenes/playlist.toml"); }

std::vector<PlaylistScene> find_playlist(const std::optional<std::filesystem::path>& path) {
  if (path) return read_playlist(*path);
  const std::optional<std::filesystem::path> installed = installed_playlist();
  return installed ? read_playlist(*installed) : std::vector<PlaylistScene>{};
}

PlaylistScene resolve_scene(const std::string& argument, std::span<const PlaylistScene> playlist) {
  if (is_scene_file(argument)) return scene_of_file(argument);
  const auto found = std::ranges::find(playlist, argument, &PlaylistScene::name);
  if (found != playlist.end()) return *found;
  std::vector<std::string> names;
  for (const PlaylistScene& scene : playlist) names.push_back(scene.name);
  throw InputError(argument, "", "no such scene",
                   "name a .gltf or .glb file, or a scene of the playlist: " + name_remedy(argument, names));
}

}  // namespace vitrine
