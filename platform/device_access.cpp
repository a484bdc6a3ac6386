#include "device_access.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <optional>
#include <system_error>
#include <utility>

#include <grp.h>
#include <sys/stat.h>

namespace vitrine {
namespace {

std::optional<unsigned> number_after(std::string_view prefix, std::string_view name) {
  if (!name.starts_with(prefix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  unsigned number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc{} && end == name.data() + name.size() ? std::optional(number) : std::nullopt;
}

std::string access_remedy(const std::filesystem::path& node) {
  struct stat status {};
  const bool grouped =
      stat(node.c_str(), &status) == 0 && (status.st_mode & S_IRGRP) != 0 && status.st_gid != 0;
  const group* const owner = grouped ? getgrgid(status.st_gid) : nullptr;
  if (owner == nullptr) return "give it to a group by a udev rule, and add the user to that";
  return "add the user to the group '" + std::string(owner->gr_name) + "'";
}

}  // namespace

std::vector<std::filesystem::path> numbered_nodes(const std::filesystem::path& folder,
                                                  std::string_view prefix) {
  std::vector<std::pair<unsigned, std::filesystem::path>> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::optional<unsigned> number = number_after(prefix, entry.path().filename().string());
    if (number && !entry.is_symlink(error)) found.emplace_back(*number, entry.path());
  }
  std::ranges::sort(found);
  std::vector<std::filesystem::path> nodes;
  for (auto& [number, node] : found) nodes.push_back(std::move(node));
  return nodes;
}

std::string open_problem(const std::filesystem::path& node, int error) {
  const std::string reason = node.string() + ": " + std::generic_category().message(error) + "; ";
  if (error == EACCES || error == EPERM) return reason + access_remedy(node);
  return reason + "see whether its driver is at work (dmesg)";
}

}  // namespace vitrine
