// Which dimensions of a sample serve what, so that a sequence that is good in groups of four dimensions gives
// each decision a group of its own. Lights: choice of light, choice of its part, u, v. Scattering: u, v,
// choice of lobe, survival.
#pragma once

#include <cstdint>

namespace vitrine {

inline constexpr std::uint32_t kCameraDimension = 0;

/// Of the direct light at a path's vertex after `depth` scattering events.
constexpr std::uint32_t light_dimension(std::uint32_t depth) { return 4 + 8 * depth; }
/// Of the scattering there.
constexpr std::uint32_t scatter_dimension(std::uint32_t depth) { return 8 + 8 * depth; }

}  // namespace vitrine
