#include "output_file.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <unistd.h>

namespace vitrine {

void require_writable(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::string reason;
  if (std::filesystem::is_directory(file)) {
    reason = "it is a folder";
  } else if (access((std::filesystem::exists(file) ? file : folder).c_str(), W_OK) != 0) {
    reason = std::strerror(errno);
  } else {
    return;
  }
  throw std::runtime_error(file.string() + ": cannot be written: " + reason +
                           "; name a file in a folder that exists and is writable");
}

}  // namespace vitrine
