// The one folder that a box writes into: its root may be read-only. systemd makes it (RuntimeDirectory=) and
// names it; it is in memory and outlives a restart, so that the last words of a program that failed are there
// for the one that shows them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace vitrine {

/// The first folder of RUNTIME_DIRECTORY, if it is set.
[[nodiscard]] std::optional<std::filesystem::path> runtime_folder_of_service();

/// Keeps `words` in the folder, or removes what was kept when they are empty. Never fails.
void keep_last_words(const std::filesystem::path& folder, const std::string& words);

/// What the box says when it could not run: the last words in `folder`, else the result of the service that
/// failed, as systemd tells the service that was started in its place (MONITOR_SERVICE_RESULT, ...).
[[nodiscard]] std::string why_it_failed(const std::optional<std::filesystem::path>& folder);

}  // namespace vitrine
