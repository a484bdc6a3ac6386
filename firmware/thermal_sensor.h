// The machine's temperature and whether it has throttled itself, as sysfs tells them.
#pragma once

#include <filesystem>
#include <optional>

#include "thermal_governor.h"

namespace vitrine {

/// The temperature file of the first zone in `folder` whose type names the processor ("cpu", "soc",
/// "x86_pkg_temp"), else of the first zone; nothing when there is none.
[[nodiscard]] std::optional<std::filesystem::path> find_thermal_zone(
    const std::filesystem::path& folder = "/sys/class/thermal");

/// Reads `temperature` (thousandths of a degree Celsius) and `throttled` (a number, decimal or 0x...; its
/// lowest four bits say what is so now, as the Raspberry Pi's firmware has it: under-voltage, capped,
/// throttled, soft limit). What is not named or cannot be read is left out.
[[nodiscard]] ThermalReading read_thermals(const std::optional<std::filesystem::path>& temperature,
                                           const std::optional<std::filesystem::path>& throttled);

}  // namespace vitrine
