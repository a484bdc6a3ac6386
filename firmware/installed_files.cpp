#include "installed_files.h"

#include <algorithm>
#include <system_error>

namespace vitrine {
namespace {

std::filesystem::path share_folder() {
  std::error_code ignored;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  return (program.parent_path() / "../share/vitrine").lexically_normal();
}

}  // namespace

std::optional<std::filesystem::path> installed_file(const std::string& name) {
  const std::filesystem::path file = share_folder() / name;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return std::nullopt;
  return file;
}

std::vector<std::string> installed_files(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(share_folder() / folder, ignored))
    names.push_back(folder + "/" + entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

}  // namespace vitrine
