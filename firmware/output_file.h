// Files to be written at the end of long work: whether that will be possible is asked at its beginning.
#pragma once

#include <filesystem>

namespace vitrine {

/// Throws std::runtime_error with the path when `file` cannot be written.
void require_writable(const std::filesystem::path& file);

}  // namespace vitrine
