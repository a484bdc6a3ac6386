#include "thermal_sensor.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace vitrine {
namespace {

constexpr std::array<std::string_view, 3> kProcessorTypes{"cpu", "soc", "x86_pkg_temp"};

std::optional<std::string> first_word(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string word;
  if (!(stream >> word)) return std::nullopt;
  return word;
}

/// Decimal or 0x...
std::optional<long> read_number(const std::filesystem::path& file) {
  const std::optional<std::string> word = first_word(file);
  if (!word) return std::nullopt;
  try {
    std::size_t used = 0;
    const long number = std::stol(*word, &used, 0);
    return used == word->size() ? std::optional(number) : std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<std::filesystem::path> find_thermal_zone(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> zones;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (entry.path().filename().string().starts_with("thermal_zone")) zones.push_back(entry.path());
  }
  // thermal_zone2 before thermal_zone10
  std::ranges::sort(zones, {}, [](const std::filesystem::path& zone) {
    const std::string name = zone.filename().string();
    return std::pair(name.size(), name);
  });
  const auto of_processor = std::ranges::find_if(zones, [](const std::filesystem::path& zone) {
    const std::string type = first_word(zone / "type").value_or("");
    return std::ranges::any_of(kProcessorTypes,
                               [&](std::string_view part) { return type.find(part) != std::string::npos; });
  });
  if (of_processor != zones.end()) return *of_processor / "temp";
  if (!zones.empty()) return zones.front() / "temp";
  return std::nullopt;
}

ThermalReading read_thermals(const std::optional<std::filesystem::path>& temperature,
                             const std::optional<std::filesystem::path>& throttled) {
  constexpr long kNow = 0xF;
  ThermalReading reading;
  if (temperature) {
    if (const auto millidegrees = read_number(*temperature))
      reading.temperature_c = static_cast<double>(*millidegrees) / 1000.0;
  }
  if (throttled) {
    if (const auto flags = read_number(*throttled)) reading.throttled = (*flags & kNow) != 0;
  }
  return reading;
}

}  // namespace vitrine
