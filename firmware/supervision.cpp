#include "supervision.h"

#include <charconv>
#include <cstdint>
#include <string_view>

#include <unistd.h>

namespace vitrine {
namespace {

std::optional<std::int64_t> whole_number(const char* text) {
  if (text == nullptr) return std::nullopt;
  const std::string_view digits(text);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return number;
}

}  // namespace

std::optional<std::chrono::microseconds> watchdog_time(const char* usec, const char* pid) {
  const std::optional<std::int64_t> time = whole_number(usec);
  if (!time || *time <= 0) return std::nullopt;
  if (pid != nullptr && whole_number(pid) != std::int64_t{getpid()}) return std::nullopt;
  return std::chrono::microseconds(*time);
}

}  // namespace vitrine
