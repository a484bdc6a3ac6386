#include "manners_config.h"

#include <array>
#include <string>

#include "toml_reader.h"

namespace vitrine {
namespace {

constexpr double kADay_s = 86'400.0;

TimeOfDay needed_time(const TomlReader& reader, const std::string& key) {
  const std::string remedy = "write it like \"22:00\"";
  const std::optional<std::string> text = reader.text(key);
  if (!text) throw reader.error("this dim has no '" + key + "'", remedy);
  const std::optional<TimeOfDay> time = parse_time_of_day(*text);
  if (!time) throw reader.error(key, "'" + *text + "' is no time of day", remedy);
  return *time;
}

}  // namespace

std::optional<IdleSettings> read_idle(const std::filesystem::path& path, const toml::table& root) {
  const toml::table* table = optional_table(path, root, "idle");
  if (table == nullptr) return std::nullopt;
  const TomlReader reader(path, *table, {"after_s", "every_s", "reset_s", "tour"});
  const std::array<std::string, 2> tours{"lecture", "scenes"};
  IdleSettings idle;
  idle.after = reader.seconds("after_s", 1.0, kADay_s);
  idle.reset = reader.seconds("reset_s", 1.0, kADay_s);
  if (const auto every = reader.seconds("every_s", 0.5, kADay_s)) idle.every = *every;
  if (const auto tour = reader.choice("tour", tours)) idle.tour = static_cast<IdleTour>(*tour);
  for (const std::string key : {"every_s", "tour"}) {
    if (reader.has(key) && !idle.after)
      throw reader.error(key, key + " without after_s", "add after_s = SECONDS, when the tour begins");
  }
  return idle;
}

std::vector<DimSpan> read_dim(const std::filesystem::path& path, const toml::table& root) {
  std::vector<DimSpan> spans;
  for (const toml::table* table : optional_tables(path, root, "dim")) {
    const TomlReader reader(path, *table, {"from", "to", "level"});
    const std::optional<double> level = reader.number("level", 0.0, 1.0);
    if (!level) throw reader.error("this dim has no 'level'", "write one from 0 (black) to 1");
    const DimSpan span{needed_time(reader, "from"), needed_time(reader, "to"), *level};
    if (span.from == span.to)
      throw reader.error("to", "this dim ends when it begins", "give it another time of day");
    spans.push_back(span);
  }
  return spans;
}

}  // namespace vitrine
