// TOML that says where it is wrong: every error names file, line and column, every unknown key its nearest
// known one.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "scene/input_error.h"

namespace vitrine {

/// Reads `path`. Throws InputError when it cannot be read or is no TOML.
toml::table read_toml(const std::filesystem::path& path);

/// An error at a place of a TOML file.
InputError toml_error(const std::filesystem::path& path, const toml::source_region& place,
                      const std::string& problem, const std::string& remedy);

/// Throws InputError when `table` has a key that is not one of `known`.
void require_known_keys(const std::filesystem::path& path, const toml::table& table,
                        std::span<const std::string> known);
inline void require_known_keys(const std::filesystem::path& path, const toml::table& table,
                               std::initializer_list<std::string> known) {
  require_known_keys(path, table, std::span(known.begin(), known.size()));
}

/// The tables of a file whose only key is the array of tables `key`. Throws InputError when there is none.
/// `content` completes "write a [[KEY]] table for each, with ...".
std::vector<const toml::table*> toml_tables(const std::filesystem::path& path, const toml::table& root,
                                            const std::string& key, const std::string& content);

/// The value of `key`, nothing when absent. Throws InputError when it is no T. `expected` completes "KEY must
/// be ...".
template <class T>
std::optional<T> toml_value(const std::filesystem::path& path, const toml::table& table,
                            const std::string& key, const std::string& expected) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return std::nullopt;
  if (std::optional<T> value = node->value_exact<T>()) return value;
  throw toml_error(path, node->source(), "'" + key + "' has another type", "it must be " + expected);
}

}  // namespace vitrine
