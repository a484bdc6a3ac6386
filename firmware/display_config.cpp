// The table [display] of a config or a board file.
#include <algorithm>
#include <array>

#include "backends.h"
#include "hardware_config.h"
#include "nearest_name.h"
#include "toml_reader.h"

namespace vitrine {
namespace {

constexpr std::array kRotations{0, 90, 180, 270};

/// The value of `key`, if it is there.
std::optional<std::string> read_backend(const std::filesystem::path& path, const toml::table& table,
                                        const std::string& key) {
  std::optional<std::string> backend = toml_value<std::string>(path, table, key, "a string");
  if (!backend) return std::nullopt;
  // Not every build has every backend, and a config may serve several: only what no build knows is wrong.
  std::vector<std::string> known{"auto", "sdl", "drm", "fbdev", "headless"};
  for (const DisplayBackend& row : display_backends()) {
    if (std::ranges::find(known, row.key) == known.end()) known.emplace_back(row.key);
  }
  if (std::ranges::find(known, *backend) != known.end()) return backend;
  throw toml_error(path, table.get(key)->source(), "no display is named '" + *backend + "'",
                   name_remedy(*backend, known));
}

}  // namespace

DisplayOptions DisplayConfig::options() const {
  DisplayOptions options;
  options.card = card.value_or("");
  options.connector = connector.value_or("");
  options.mode = mode.value_or("");
  options.device = device.value_or("");
  options.rotation = rotation.value_or(0);
  options.scaling = scaling.value_or(options.scaling);
  options.format = format;
  return options;
}

DisplayConfig read_display(const std::filesystem::path& path, const toml::table& root) {
  const toml::node* node = root.get("display");
  if (node == nullptr) return {};
  DisplayConfig display;
  if (node->is_string()) {
    display.backend = read_backend(path, root, "display");
    return display;
  }
  const TomlReader reader(
      path, *optional_table(path, root, "display"),
      {"backend", "card", "connector", "mode", "device", "rotation", "scaling", "format"});
  const std::array<std::string, 2> scalings{"fitted", "integer"};
  const std::array<std::string, 3> formats{"xrgb8888", "rgb888", "rgb565"};
  display.backend = read_backend(path, reader.table(), "backend");
  display.card = reader.text("card");
  display.connector = reader.text("connector");
  display.mode = reader.text("mode");
  display.device = reader.text("device");
  if (const auto rotation = reader.whole("rotation", 0, 270)) {
    if (std::ranges::find(kRotations, *rotation) == kRotations.end())
      throw reader.error("rotation", std::to_string(*rotation) + " is no rotation",
                         "write 0, 90, 180 or 270");
    display.rotation = static_cast<int>(*rotation);
  }
  if (const auto scaling = reader.choice("scaling", scalings))
    display.scaling = static_cast<Scaling>(*scaling);
  if (const auto format = reader.choice("format", formats))
    display.format = static_cast<PixelFormat>(*format);
  return display;
}

}  // namespace vitrine
