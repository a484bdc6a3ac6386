#include "integrators/modes.h"

#include <algorithm>
#include <array>

namespace vitrine {
namespace {

constexpr SamplingParts by_chance(DirectionSampling direction) {
  return {.direction = direction, .direct = DirectLight::kByChance};
}
constexpr SamplingParts next_event(LightSelection lights) {
  return {.direct = DirectLight::kNextEvent, .lights = lights};
}

constexpr auto kModes = std::to_array<Mode>({
    {"basic", "Basic path tracing", "Basic Path Tracing", by_chance(DirectionSampling::kUniform), "nee"},
    {"basic-cosine", "Cosine distribution", "Indirect Illumination - Cosine Dist.",
     by_chance(DirectionSampling::kCosine), "basic"},
    {"basic-brdf", "BRDF distribution", "Indirect Illumination - BRDF Dist.",
     by_chance(DirectionSampling::kBrdf), "basic"},
    {"basic-brdf-cosine", "BRDF x cosine distribution", "Indirect Illumination - BRDF*Cosine Dist.",
     by_chance(DirectionSampling::kBrdfCosine), "basic-cosine"},
    {"nee", "Next event estimation", "Next Event Estimation", next_event(LightSelection::kUniform), "basic"},
    {"nee-all", "Next event estimation, all lights", "Direct Illumination - Many Lights",
     next_event(LightSelection::kAll), "nee"},
    {"nee-power", "Next event estimation, lights by power", "Direct Illumination - Many Lights",
     next_event(LightSelection::kPower), "nee"},
    {"nee-tree", "Next event estimation, light tree", "Direct Illumination - Many Lights",
     next_event(LightSelection::kTree), "nee-power"},
    {"mis",
     "Multiple importance sampling",
     "beyond the slides",
     {.lights = LightSelection::kTree},
     "nee-tree"},
});

}  // namespace

std::span<const Mode> modes() { return kModes; }

const Mode* find_mode(std::string_view key) {
  const auto found = std::ranges::find(kModes, key, &Mode::key);
  return found == kModes.end() ? nullptr : &*found;
}

}  // namespace vitrine
