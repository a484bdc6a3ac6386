#include "box_config.h"

#include "mode_choice.h"
#include "nearest_name.h"
#include "strict_toml.h"

namespace vitrine {
BoxConfig read_box_config(const std::filesystem::path& path) {
  const toml::table root = read_toml(path);
  require_known_keys(path, root,
                     {"display", "buttons", "playlist", "lecture", "size", "mode", "numbers", "threads",
                      "environment", "environment_nits", "environment_rotation"});
  const auto text = [&](const std::string& key) {
    return toml_value<std::string>(path, root, key, "a string");
  };
  const auto error = [&](const std::string& key, const std::string& remedy) {
    return toml_error(path, root.get(key)->source(), "this is no " + key, remedy);
  };

  BoxConfig config;
  config.display = text("display");
  config.buttons = text("buttons");
  if (const auto playlist = text("playlist")) config.playlist = path.parent_path() / *playlist;
  if (const auto lecture = text("lecture")) config.lecture = path.parent_path() / *lecture;
  if (const auto size = text("size")) {
    config.size = parse_size(*size);
    if (!config.size) throw error("size", "write it like \"800x480\"; a side has 1 to 8192 pixels");
  }
  if (const auto key = text("mode")) {
    config.mode = find_mode(*key);
    if (*config.mode == nullptr) throw error("mode", name_remedy(*key, mode_keys()));
  }
  if (const auto name = text("numbers")) {
    config.numbers = numbers_from_name(*name);
    if (!config.numbers) throw error("numbers", "write \"float\" or \"fixed\"");
  }
  if (const auto threads = toml_value<std::int64_t>(path, root, "threads", "a whole number")) {
    if (*threads < 1 || *threads > 1024) throw error("threads", "write a number from 1 to 1024");
    config.threads = static_cast<int>(*threads);
  }
  config.environment = read_environment_choice(path, root);
  return config;
}

BoxConfig overlay(const BoxConfig& base, const BoxConfig& over) {
  BoxConfig both = base;
  if (over.display) both.display = over.display;
  if (over.buttons) both.buttons = over.buttons;
  if (over.playlist) both.playlist = over.playlist;
  if (over.lecture) both.lecture = over.lecture;
  if (over.size) both.size = over.size;
  if (over.mode) both.mode = over.mode;
  if (over.numbers) both.numbers = over.numbers;
  if (over.threads) both.threads = over.threads;
  if (over.environment) both.environment = over.environment;
  return both;
}

}  // namespace vitrine
