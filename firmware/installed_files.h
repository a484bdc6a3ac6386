// What is installed with the program, in ../share/vitrine of its folder; a build folder looks the same.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// "scenes/playlist.toml", if it is there.
std::optional<std::filesystem::path> installed_file(const std::string& name);

/// The files of an installed folder: "boards/a.toml", in order.
std::vector<std::string> installed_files(const std::string& folder);

}  // namespace vitrine
