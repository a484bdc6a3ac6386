#include "dim_schedule.h"

#include <algorithm>
#include <charconv>
#include <ctime>

namespace vitrine {

double dim_level(std::span<const DimSpan> spans, TimeOfDay now) {
  double level = 1.0;
  for (const DimSpan& span : spans) {
    const bool over_midnight = span.to <= span.from;
    const bool holds = over_midnight ? now >= span.from || now < span.to : now >= span.from && now < span.to;
    if (holds) level = std::min(level, span.level);
  }
  return level;
}

std::optional<TimeOfDay> parse_time_of_day(std::string_view text) {
  constexpr std::size_t kColon = 2;
  if (text.size() != 5 || text[kColon] != ':') return std::nullopt;
  const auto number = [](std::string_view digits, int most) -> std::optional<int> {
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || end != digits.data() + digits.size() || value < 0 || value > most)
      return std::nullopt;
    return value;
  };
  const std::optional<int> hours = number(text.substr(0, kColon), 23);
  const std::optional<int> minutes = number(text.substr(kColon + 1), 59);
  if (!hours || !minutes) return std::nullopt;
  return std::chrono::hours(*hours) + std::chrono::minutes(*minutes);
}

TimeOfDay local_time_of_day() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  return std::chrono::hours(local.tm_hour) + std::chrono::minutes(local.tm_min);
}

}  // namespace vitrine
