#include "integrators/modes.h"

#include <algorithm>
#include <array>

namespace vitrine {
namespace {

constexpr auto kModes = std::to_array<Mode>({
    {.key = "basic",
     .label = "Basic path tracing",
     .section = "Basic Path Tracing",
     .unbiased = true,
     .direction = DirectionSampling::kUniform,
     .direct = DirectLight::kByChance},
    {.key = "nee",
     .label = "Next event estimation",
     .section = "Next Event Estimation",
     .unbiased = true,
     .direction = DirectionSampling::kBsdf,
     .direct = DirectLight::kNextEvent},
    {.key = "mis",
     .label = "Multiple importance sampling",
     .section = "beyond the slides",
     .unbiased = true,
     .direction = DirectionSampling::kBsdf,
     .direct = DirectLight::kMis},
});

}  // namespace

std::span<const Mode> modes() { return kModes; }

const Mode* find_mode(std::string_view key) {
  const auto found = std::ranges::find(kModes, key, &Mode::key);
  return found == kModes.end() ? nullptr : &*found;
}

}  // namespace vitrine
