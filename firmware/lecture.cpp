#include "lecture.h"

#include <system_error>

#include "installed_files.h"
#include "nearest_name.h"
#include "strict_toml.h"

namespace vitrine {
namespace {

/// The scene files beside a lecture.
std::vector<std::string> scene_files(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (is_scene_file(entry.path())) names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

class StopReader {
 public:
  StopReader(const std::filesystem::path& path, const toml::table& table) : path_(path), table_(table) {
    std::vector<std::string> known{"section", "caption", "scene", "mode", "compare", "equal"};
    for (const Parameter& parameter : parameters()) known.emplace_back(parameter.name);
    require_known_keys(path_, table_, known);
  }

  [[nodiscard]] LectureStop read() const {
    return {.section = needed_text("section"),
            .caption = needed_text("caption"),
            .scene = read_scene(),
            .techniques = read_techniques(),
            .fairness = read_fairness()};
  }

 private:
  [[nodiscard]] std::optional<std::string> text(const std::string& key) const {
    return toml_value<std::string>(path_, table_, key, "a string");
  }
  [[nodiscard]] std::string needed_text(const std::string& key) const {
    const std::optional<std::string> value = text(key);
    if (value && !value->empty()) return *value;
    throw toml_error(path_, table_.source(), "this stop has no " + key, "add " + key + " = \"...\"");
  }
  /// Runs `parse`; what it does not know is an error at the value of `key`.
  template <class Parse>
  auto at(const std::string& key, const Parse& parse) const {
    try {
      return parse();
    } catch (const UnknownChoice& unknown) {
      throw toml_error(path_, table_.get(key)->source(), unknown.what(), unknown.remedy());
    }
  }

  [[nodiscard]] PlaylistScene read_scene() const {
    const std::string name = needed_text("scene");
    PlaylistScene scene = scene_of_file(path_.parent_path() / name);
    std::error_code ignored;
    if (!is_scene_file(scene.file) || !std::filesystem::is_regular_file(scene.file, ignored)) {
      throw toml_error(path_, table_.get("scene")->source(), "no scene file '" + name + "'",
                       name_remedy(name, scene_files(scene.file.parent_path())));
    }
    return scene;
  }

  [[nodiscard]] std::vector<Technique> read_techniques() const {
    const std::optional<std::string> mode = text("mode");
    const std::optional<std::string> compare = text("compare");
    if (mode.has_value() == compare.has_value()) {
      throw toml_error(path_, table_.source(),
                       mode ? "this stop has a mode and a comparison" : "this stop has no mode",
                       "write either mode = \"KEY\" or compare = \"A,B\"");
    }
    std::vector<Technique> techniques = mode ? at("mode", [&] { return std::vector{parse_technique(*mode)}; })
                                             : at("compare", [&] { return parse_comparison(*compare); });
    for (const Parameter& parameter : parameters()) {
      const std::string key(parameter.name);
      if (!table_.contains(key)) continue;
      at(key, [&] {
        const ParameterChange change = parse_change(key, value_of(key));
        for (Technique& technique : techniques) apply(change, technique);
      });
    }
    return techniques;
  }

  /// Of a parameter: a string or a whole number.
  [[nodiscard]] std::string value_of(const std::string& key) const {
    if (table_.get(key)->is_integer()) return std::to_string(*table_.get(key)->value<std::int64_t>());
    return *toml_value<std::string>(path_, table_, key, "a string or a whole number");
  }

  [[nodiscard]] Fairness read_fairness() const {
    const std::string value = text("equal").value_or("samples");
    if (value == "samples") return Fairness::kEqualSamples;
    if (value == "time") return Fairness::kEqualTime;
    throw toml_error(path_, table_.get("equal")->source(), "'" + value + "' cannot be equal",
                     "write \"samples\" or \"time\"");
  }

  const std::filesystem::path& path_;
  const toml::table& table_;
};

}  // namespace

std::vector<LectureStop> read_lecture(const std::filesystem::path& path) {
  const toml::table root = read_toml(path);
  std::vector<LectureStop> stops;
  for (const toml::table* table : toml_tables(path, root, "stop", "section, caption, scene and mode"))
    stops.push_back(StopReader(path, *table).read());
  return stops;
}

std::vector<LectureStop> find_lecture(const std::optional<std::filesystem::path>& path) {
  if (path) return read_lecture(*path);
  const std::optional<std::filesystem::path> installed = installed_file("scenes/lecture.toml");
  return installed ? read_lecture(*installed) : std::vector<LectureStop>{};
}

const LectureStop& LectureTour::go_on() {
  if (under_way_) index_ = (index_ + 1) % stops_.size();
  under_way_ = true;
  return stops_[index_];
}

std::string LectureTour::title() const {
  return std::to_string(index_ + 1) + "/" + std::to_string(stops_.size()) + " " + stops_[index_].section;
}

}  // namespace vitrine
