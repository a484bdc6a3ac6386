// The tables [[gpio]] and [[evdev]] of a config or a board file.
#include "backends.h"
#include "hardware_config.h"
#include "toml_reader.h"

namespace vitrine {
namespace {

std::string needed_button(const TomlReader& reader) {
  const std::optional<std::string> button = reader.text("button");
  if (button && !button->empty()) return *button;
  throw reader.error("this gpio has no button", "add button = \"NAME\"");
}

/// A name, or an offset as a number.
std::string needed_line(const TomlReader& reader) {
  const toml::node* node = reader.table().get("line");
  if (node != nullptr && node->is_integer()) return std::to_string(*reader.whole("line", 0, 65'535));
  const std::optional<std::string> line = reader.text("line");
  if (line && !line->empty()) return *line;
  throw reader.error("this gpio has no line", "add line = \"NAME\", or line = OFFSET and chip = \"LABEL\"");
}

Bias read_bias(const TomlReader& reader) {
  std::vector<std::string> names;
  for (const BiasName& bias : kBiasNames) names.emplace_back(bias.name);
  const std::optional<std::size_t> index = reader.choice("bias", names);
  return index ? kBiasNames[*index].bias : Bias::kAsIs;
}

GpioLine read_line(const TomlReader& reader) {
  GpioLine line{.button = needed_button(reader),
                .chip = reader.text("chip").value_or(""),
                .line = needed_line(reader),
                .active_low = reader.flag("active_low").value_or(false),
                .bias = read_bias(reader),
                .debounce = reader.milliseconds("debounce_ms", 0, 1000).value_or(kDefaultDebounce)};
  const bool is_offset = line.line.find_first_not_of("0123456789") == std::string::npos;
  if (is_offset && line.chip.empty())
    throw reader.error("line", "an offset without a chip", "add chip = \"LABEL\", or name the line");
  return line;
}

std::map<std::string, std::string> read_keys(const TomlReader& reader) {
  const toml::node* node = reader.table().get("keys");
  if (node == nullptr) return {};
  const toml::table* table = node->as_table();
  const std::string form = "write it like keys = {KEY_NEXT = \"scene\", \"REL_X+\" = \"mode\"}";
  if (table == nullptr || table->empty()) throw reader.error("keys", "'keys' has another type", form);
  std::map<std::string, std::string> keys;
  for (const auto& [key, value] : *table) {
    const std::string code(key.str());
    if (!code.starts_with("KEY_") && !code.starts_with("BTN_") && !code.starts_with("REL_")) {
      throw toml_error(reader.path(), key.source(), "'" + code + "' is no key of an input device",
                       "name a KEY_..., a BTN_..., or a REL_... with + or - behind it");
    }
    if (const std::string remedy = key_remedy(code); !remedy.empty())
      throw toml_error(reader.path(), key.source(), "no key or axis step is called '" + code + "'", remedy);
    const std::optional<std::string> button = value.value_exact<std::string>();
    if (!button || button->empty())
      throw toml_error(reader.path(), value.source(), "'" + code + "' needs the name of a button", form);
    keys.emplace(code, *button);
  }
  return keys;
}

}  // namespace

std::vector<Placed<GpioLine>> read_gpio(const std::filesystem::path& path, const toml::table& root) {
  std::vector<Placed<GpioLine>> lines;
  for (const toml::table* table : optional_tables(path, root, "gpio")) {
    const TomlReader reader(path, *table, {"button", "chip", "line", "active_low", "bias", "debounce_ms"});
    GpioLine line = read_line(reader);
    for (const Placed<GpioLine>& before : lines) {
      if (before.value.chip == line.chip && before.value.line == line.line)
        throw reader.error("line", "a second button on line '" + line.line + "'",
                           "wire one of them elsewhere");
    }
    lines.push_back({std::move(line), path, table->source()});
  }
  return lines;
}

std::vector<Placed<EvdevDevice>> read_evdev(const std::filesystem::path& path, const toml::table& root) {
  std::vector<Placed<EvdevDevice>> devices;
  for (const toml::table* table : optional_tables(path, root, "evdev")) {
    const TomlReader reader(path, *table, {"name", "grab", "keys"});
    EvdevDevice device{.name = reader.text("name").value_or(""),
                       .keys = read_keys(reader),
                       .grab = reader.flag("grab").value_or(false)};
    for (const Placed<EvdevDevice>& before : devices) {
      if (before.value.name == device.name) {
        throw reader.error("a second device '" + device.name + "'",
                           device.name.empty() ? "add name = \"...\"" : "join the two tables");
      }
    }
    devices.push_back({std::move(device), path, table->source()});
  }
  return devices;
}

}  // namespace vitrine
