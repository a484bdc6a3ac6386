#include "box_config.h"

#include <algorithm>
#include <sstream>
#include <system_error>

#include "backends.h"
#include "installed_files.h"
#include "mode_choice.h"
#include "nearest_name.h"
#include "toml_reader.h"

namespace vitrine {
namespace {

std::vector<std::string> known_keys() {
  std::vector<std::string> keys = kHardwareKeys;
  keys.insert(keys.end(), {"board", "buttons", "playlist", "lecture", "size", "mode", "numbers", "threads",
                           "max_spp", "environment", "environment_nits", "environment_rotation",
                           "screenshots", "pixel_shift", "idle", "dim", "governor", "health"});
  return keys;
}

/// Beside the config, or else installed.
std::filesystem::path find_board(const TomlReader& reader, const std::filesystem::path& beside) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(beside, ignored)) return beside;
  const std::string name = *reader.text("board");
  if (const auto installed = installed_file(name)) return *installed;
  const std::vector<std::string> boards = installed_files("boards");
  throw reader.error("board", "no board file '" + name + "' beside this file or installed",
                     name_remedy(name, boards));
}

HardwareConfig read_all_hardware(const TomlReader& reader) {
  HardwareConfig hardware = read_hardware(reader.path(), reader.table());
  if (const auto beside = reader.file("board"))
    hardware = overlay(read_board(find_board(reader, *beside)), hardware);
  require_consistent(hardware);
  return hardware;
}

std::optional<std::string> read_buttons(const TomlReader& reader) {
  std::optional<std::string> list = reader.text("buttons");
  if (!list) return std::nullopt;
  std::vector<std::string> known{"auto", "gpio", "evdev", "sdl", "script"};  // as for displays: of any build
  for (const ButtonsBackend& row : buttons_backends()) {
    if (std::ranges::find(known, row.key) == known.end()) known.emplace_back(row.key);
  }
  std::istringstream keys(*list);
  for (std::string key; std::getline(keys, key, ',');) {
    if (std::ranges::find(known, key) == known.end())
      throw reader.error("buttons", "no buttons are named '" + key + "'", name_remedy(key, known));
  }
  return list;
}

}  // namespace

BoxConfig read_box_config(const std::filesystem::path& path) {
  const toml::table root = read_toml(path);
  const TomlReader reader(path, root, known_keys());

  BoxConfig config;
  config.hardware = read_all_hardware(reader);
  config.buttons = read_buttons(reader);
  config.playlist = reader.file("playlist");
  config.lecture = reader.file("lecture");
  config.screenshots = reader.file("screenshots");
  config.pixel_shift = reader.flag("pixel_shift");
  if (const auto size = reader.text("size")) {
    config.size = parse_size(*size);
    if (!config.size)
      throw reader.error("size", "this is no size", "write it like \"800x480\"; a side has 1 to 8192 pixels");
  }
  if (const auto key = reader.text("mode")) {
    config.mode = find_mode(*key);
    if (*config.mode == nullptr)
      throw reader.error("mode", "this is no mode", name_remedy(*key, mode_keys()));
  }
  if (const auto name = reader.text("numbers")) {
    config.numbers = numbers_from_name(*name);
    if (!config.numbers) throw reader.error("numbers", "this is no numbers", "write \"float\" or \"fixed\"");
  }
  if (const auto threads = reader.whole("threads", 1, 1024)) config.threads = static_cast<int>(*threads);
  if (const auto spp = reader.whole("max_spp", 1, 1 << 20)) config.max_spp = static_cast<std::uint32_t>(*spp);
  config.environment = read_environment_choice(path, root);
  config.idle = read_idle(path, root);
  config.dim = read_dim(path, root);
  config.governor = read_governor(path, root);
  config.health = read_health(path, root);
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
  if (over.max_spp) both.max_spp = over.max_spp;
  if (over.environment) both.environment = over.environment;
  if (over.screenshots) both.screenshots = over.screenshots;
  return both;
}

}  // namespace vitrine
