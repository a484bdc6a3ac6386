#include "environment_choice.h"

#include <string>
#include <system_error>

#include "scene/input_error.h"
#include "strict_toml.h"

namespace vitrine {
namespace {

std::optional<double> read_number(const std::filesystem::path& path, const toml::table& table,
                                  const std::string& key, double low, double high) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return std::nullopt;
  const std::optional<double> number = node->is_number() ? node->value<double>() : std::nullopt;
  if (!number || !(*number >= low && *number <= high)) {
    throw toml_error(path, node->source(), "this is no " + key,
                     "write a number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  if (!table.contains("environment"))
    throw toml_error(path, node->source(), key + " without environment", "add environment = \"FILE.hdr\"");
  return number;
}

}  // namespace

std::optional<EnvironmentChoice> read_environment_choice(const std::filesystem::path& path,
                                                         const toml::table& table) {
  const auto nits = read_number(path, table, "environment_nits", 1e-6, kMaxEnvironmentNits);
  const auto rotation = read_number(path, table, "environment_rotation", -kMaxEnvironmentRotation_deg,
                                    kMaxEnvironmentRotation_deg);
  const auto file = toml_value<std::string>(path, table, "environment", "a string");
  if (!file) return std::nullopt;
  EnvironmentChoice choice{.file = path.parent_path() / *file};
  if (nits) choice.nits = *nits;
  if (rotation) choice.rotation_deg = *rotation;
  return choice;
}

void require_environment(const EnvironmentChoice& choice) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(choice.file, ignored)) return;
  throw InputError(choice.file.string(), "", "there is no such file", "name a Radiance .hdr picture");
}

}  // namespace vitrine
