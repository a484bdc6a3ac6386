#include "strict_toml.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "nearest_name.h"

namespace vitrine {

toml::table read_toml(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) {
    throw InputError(path.string(), "", "cannot be read", "name a readable TOML file");
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  try {
    return toml::parse(text, path.string());
  } catch (const toml::parse_error& error) {
    throw toml_error(path, error.source(), std::string(error.description()), "correct this line");
  }
}

InputError toml_error(const std::filesystem::path& path, const toml::source_region& place,
                      const std::string& problem, const std::string& remedy) {
  return InputError(
      path.string(),
      "line " + std::to_string(place.begin.line) + ", column " + std::to_string(place.begin.column), problem,
      remedy);
}

void require_known_keys(const std::filesystem::path& path, const toml::table& table,
                        std::span<const std::string> known) {
  for (const auto& [key, value] : table) {
    if (std::ranges::find(known, key.str()) != known.end()) continue;
    throw toml_error(path, key.source(), "unknown key '" + std::string(key.str()) + "'",
                     name_remedy(key.str(), known));
  }
}

std::vector<const toml::table*> toml_tables(const std::filesystem::path& path, const toml::table& root,
                                            const std::string& key, const std::string& content) {
  require_known_keys(path, root, {key});
  const toml::node* list = root.get(key);
  const toml::array* tables = list == nullptr ? nullptr : list->as_array();
  if (tables == nullptr || tables->empty() || !tables->is_homogeneous<toml::table>()) {
    throw toml_error(path, (list == nullptr ? root : *list).source(), "no " + key + "s",
                     "write a [[" + key + "]] table for each, with " + content);
  }
  std::vector<const toml::table*> found;
  for (const toml::node& table : *tables) found.push_back(table.as_table());
  return found;
}

}  // namespace vitrine
