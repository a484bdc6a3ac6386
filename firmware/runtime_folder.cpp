#include "runtime_folder.h"

#include <cstdlib>
#include <fstream>
#include <system_error>

namespace vitrine {
namespace {

constexpr const char* kLastWords = "last-words";

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

std::optional<std::filesystem::path> runtime_folder_of_service() {
  const std::string folders = environment("RUNTIME_DIRECTORY");
  if (folders.empty()) return std::nullopt;
  return folders.substr(0, folders.find(':'));
}

void keep_last_words(const std::filesystem::path& folder, const std::string& words) {
  std::error_code ignored;
  if (words.empty()) {
    std::filesystem::remove(folder / kLastWords, ignored);
  } else {
    std::ofstream(folder / kLastWords) << words << '\n';
  }
}

std::string why_it_failed(const std::optional<std::filesystem::path>& folder) {
  std::string words;
  if (folder) {
    std::ifstream file(*folder / kLastWords);
    std::getline(file, words);
  }
  if (!words.empty()) return words;
  const std::string unit = environment("MONITOR_UNIT");
  const std::string result = environment("MONITOR_SERVICE_RESULT");
  if (result.empty()) return "it was started to say so; stop it and start the box";
  const std::string code = environment("MONITOR_EXIT_CODE");
  const std::string status = environment("MONITOR_EXIT_STATUS");
  return unit + " failed again and again: " + result +
         (code.empty() ? "" : " (" + code + " " + status + ")") + "; read the log: journalctl -u " + unit;
}

}  // namespace vitrine
