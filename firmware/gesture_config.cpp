// The tables [[gesture]] of a config or a board file.
#include <array>

#include "actions.h"
#include "hardware_config.h"
#include "nearest_name.h"
#include "toml_reader.h"

namespace vitrine {
namespace {

std::vector<std::string> needed_buttons(const TomlReader& reader) {
  const std::optional<std::string> one = reader.text("button");
  const std::optional<std::vector<std::string>> several = reader.texts("buttons");
  if (one.has_value() == several.has_value()) {
    throw reader.error(one ? "this gesture has a button and buttons" : "this gesture has no button",
                       "write either button = \"NAME\" or buttons = [\"A\", \"B\"]");
  }
  return one ? std::vector{*one} : *several;
}

std::string needed_action(const TomlReader& reader) {
  const std::optional<std::string> action = reader.text("action");
  if (!action) throw reader.error("this gesture has no action", "add action = \"NAME\"");
  if (find_action(*action) != nullptr) return *action;
  throw reader.error("action", "no action is named '" + *action + "'", name_remedy(*action, action_names()));
}

}  // namespace

std::vector<Placed<GestureRule>> read_gestures(const std::filesystem::path& path, const toml::table& root) {
  const std::array<std::string, 4> kinds{"short", "long", "repeat", "chord"};
  std::vector<Placed<GestureRule>> rules;
  for (const toml::table* table : optional_tables(path, root, "gesture")) {
    const TomlReader reader(path, *table, {"button", "buttons", "on", "action", "after_ms", "every_ms"});
    GestureRule rule{.buttons = needed_buttons(reader), .action = needed_action(reader)};
    const std::optional<std::size_t> kind = reader.choice("on", kinds);
    rule.kind = kind                      ? static_cast<GestureKind>(*kind)
                : rule.buttons.size() > 1 ? GestureKind::kChord
                                          : GestureKind::kShort;
    if (const auto after = reader.milliseconds("after_ms", 1, 60'000)) rule.after = *after;
    if (const auto every = reader.milliseconds("every_ms", 20, 60'000)) rule.every = *every;
    if (reader.has("every_ms") && rule.kind != GestureKind::kRepeat)
      throw reader.error("every_ms", "only a repeat has a period", "write on = \"repeat\", or leave it out");
    if (reader.has("after_ms") && rule.kind == GestureKind::kShort)
      throw reader.error("after_ms", "a short press waits for nothing", "leave after_ms out");
    rules.push_back({std::move(rule), path, table->source()});
  }
  return rules;
}

}  // namespace vitrine
