// When the box shines less: spans of the day with a level of brightness, by local time. A span may go over
// midnight.
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string_view>

namespace vitrine {

/// Since midnight.
using TimeOfDay = std::chrono::minutes;

struct DimSpan {
  TimeOfDay from{0};
  TimeOfDay to{0};     ///< excluded; not later than `from`: of the next day
  double level = 1.0;  ///< 0: black, 1: as bright as ever

  bool operator==(const DimSpan&) const = default;
};

/// The lowest level of the spans that hold `now`; 1 outside all of them.
[[nodiscard]] double dim_level(std::span<const DimSpan> spans, TimeOfDay now);

/// "22:00"; nothing for other forms.
[[nodiscard]] std::optional<TimeOfDay> parse_time_of_day(std::string_view text);

/// By the machine's clock and time zone.
[[nodiscard]] TimeOfDay local_time_of_day();

}  // namespace vitrine
