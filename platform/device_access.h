// Devices in /dev that may be there but not ours to open: which group would help.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// The nodes `folder`/PREFIXn in order of n; links to them left out.
[[nodiscard]] std::vector<std::filesystem::path> numbered_nodes(const std::filesystem::path& folder,
                                                                std::string_view prefix);

/// "PATH: REASON; REMEDY" for an error (errno) of opening a device.
[[nodiscard]] std::string open_problem(const std::filesystem::path& node, int error);

}  // namespace vitrine
