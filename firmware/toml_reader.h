// One table of a strict TOML file, value by value: each says its type and range, and whoever writes another
// one reads where, and what it should be.
#pragma once

#include <chrono>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "strict_toml.h"

namespace vitrine {

class TomlReader {
 public:
  /// Both must outlive the reader. Throws InputError when there are other keys than `known`.
  TomlReader(const std::filesystem::path& path, const toml::table& table, std::span<const std::string> known)
      : path_(path), table_(table) {
    require_known_keys(path, table, known);
  }
  TomlReader(const std::filesystem::path& path, const toml::table& table,
             std::initializer_list<std::string> known)
      : TomlReader(path, table, std::span(known.begin(), known.size())) {}

  // Nothing where the key is absent. All throw InputError.
  [[nodiscard]] std::optional<std::string> text(const std::string& key) const;
  [[nodiscard]] std::optional<bool> flag(const std::string& key) const;
  [[nodiscard]] std::optional<std::int64_t> whole(const std::string& key, std::int64_t low,
                                                  std::int64_t high) const;
  [[nodiscard]] std::optional<double> number(const std::string& key, double low, double high) const;
  /// Whole milliseconds.
  [[nodiscard]] std::optional<std::chrono::milliseconds> milliseconds(const std::string& key,
                                                                      std::int64_t low,
                                                                      std::int64_t high) const;
  /// Seconds, whole or not.
  [[nodiscard]] std::optional<std::chrono::milliseconds> seconds(const std::string& key, double low,
                                                                 double high) const;
  /// One of `names`: its index.
  [[nodiscard]] std::optional<std::size_t> choice(const std::string& key,
                                                  std::span<const std::string> names) const;
  /// Strings, at least one.
  [[nodiscard]] std::optional<std::vector<std::string>> texts(const std::string& key) const;
  /// A file or folder, relative to the folder of the file that is read.
  [[nodiscard]] std::optional<std::filesystem::path> file(const std::string& key) const;

  [[nodiscard]] bool has(const std::string& key) const { return table_.contains(key); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const toml::table& table() const { return table_; }
  /// At the value of `key`.
  [[nodiscard]] InputError error(const std::string& key, const std::string& problem,
                                 const std::string& remedy) const {
    return toml_error(path_, table_.get(key)->source(), problem, remedy);
  }
  /// At the table's head.
  [[nodiscard]] InputError error(const std::string& problem, const std::string& remedy) const {
    return toml_error(path_, table_.source(), problem, remedy);
  }

 private:
  const std::filesystem::path& path_;
  const toml::table& table_;
};

/// The table `key` of `root`, nullptr when absent. Throws InputError when it is something else.
const toml::table* optional_table(const std::filesystem::path& path, const toml::table& root,
                                  const std::string& key);
/// The array of tables `key` of `root`, none when absent. Throws InputError when it is something else.
std::vector<const toml::table*> optional_tables(const std::filesystem::path& path, const toml::table& root,
                                                const std::string& key);

}  // namespace vitrine
