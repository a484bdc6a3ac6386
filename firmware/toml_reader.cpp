#include "toml_reader.h"

#include <cmath>
#include <sstream>

#include "nearest_name.h"

namespace vitrine {
namespace {

/// As people write it: 0.5, not 0.500000.
std::string written(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

}  // namespace

std::optional<std::string> TomlReader::text(const std::string& key) const {
  return toml_value<std::string>(path_, table_, key, "a string");
}

std::optional<bool> TomlReader::flag(const std::string& key) const {
  return toml_value<bool>(path_, table_, key, "true or false");
}

std::optional<std::int64_t> TomlReader::whole(const std::string& key, std::int64_t low,
                                              std::int64_t high) const {
  const auto value = toml_value<std::int64_t>(path_, table_, key, "a whole number");
  if (value && (*value < low || *value > high)) {
    throw error(key, std::to_string(*value) + " is no " + key,
                "write a number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

std::optional<double> TomlReader::number(const std::string& key, double low, double high) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const std::optional<double> value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value || !(*value >= low && *value <= high))
    throw error(key, "this is no " + key, "write a number from " + written(low) + " to " + written(high));
  return value;
}

std::optional<std::chrono::milliseconds> TomlReader::milliseconds(const std::string& key, std::int64_t low,
                                                                  std::int64_t high) const {
  const auto value = whole(key, low, high);
  return value ? std::optional(std::chrono::milliseconds(*value)) : std::nullopt;
}

std::optional<std::chrono::milliseconds> TomlReader::seconds(const std::string& key, double low,
                                                             double high) const {
  const auto value = number(key, low, high);
  return value ? std::optional(std::chrono::milliseconds(std::llround(*value * 1000.0))) : std::nullopt;
}

std::optional<std::size_t> TomlReader::choice(const std::string& key,
                                              std::span<const std::string> names) const {
  const std::optional<std::string> value = text(key);
  if (!value) return std::nullopt;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (*value == names[i]) return i;
  }
  throw error(key, "'" + *value + "' is no " + key, name_remedy(*value, names));
}

std::optional<std::vector<std::string>> TomlReader::texts(const std::string& key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* array = node->as_array();
  if (array == nullptr || array->empty() || !array->is_homogeneous<std::string>())
    throw error(key, "'" + key + "' has another type", "it must be strings, like [\"a\", \"b\"]");
  std::vector<std::string> values;
  for (const toml::node& value : *array) values.push_back(*value.value_exact<std::string>());
  return values;
}

std::optional<std::filesystem::path> TomlReader::file(const std::string& key) const {
  const std::optional<std::string> value = text(key);
  if (!value) return std::nullopt;
  if (value->empty()) throw error(key, "'" + key + "' names nothing", "name a file, or leave the key out");
  return path_.parent_path() / *value;
}

const toml::table* optional_table(const std::filesystem::path& path, const toml::table& root,
                                  const std::string& key) {
  const toml::node* node = root.get(key);
  if (node == nullptr) return nullptr;
  if (const toml::table* table = node->as_table()) return table;
  throw toml_error(path, node->source(), "'" + key + "' has another type",
                   "write it as a [" + key + "] table");
}

std::vector<const toml::table*> optional_tables(const std::filesystem::path& path, const toml::table& root,
                                                const std::string& key) {
  const toml::node* node = root.get(key);
  if (node == nullptr) return {};
  const toml::array* array = node->as_array();
  if (array == nullptr || array->empty() || !array->is_homogeneous<toml::table>()) {
    throw toml_error(path, node->source(), "'" + key + "' has another type",
                     "write a [[" + key + "]] table for each");
  }
  std::vector<const toml::table*> tables;
  for (const toml::node& table : *array) tables.push_back(table.as_table());
  return tables;
}

}  // namespace vitrine
