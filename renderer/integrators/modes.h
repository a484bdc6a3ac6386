// The sampling modes: each is a named choice of parts, one row of one table. The command line, the kiosk's
// button cycle, the HUD and the tests iterate this table; to add a mode, add a row in modes.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace vitrine {

/// How a path finds its next direction.
enum class DirectionSampling : std::uint8_t {
  kUniform,  ///< uniform over the hemisphere (the sphere where the material transmits)
  kBsdf,     ///< as the material scatters: BSDF times cosine
};

/// How a vertex collects light that comes straight from a source.
enum class DirectLight : std::uint8_t {
  kByChance,   ///< only when a scattered ray happens to hit the source
  kNextEvent,  ///< next event estimation: a shadow ray to a sampled point of a source
  kMis,        ///< both, weighted by the power heuristic
};

struct Mode {
  std::string_view key;
  std::string_view label;
  std::string_view section;  ///< of the lecture
  bool unbiased = true;
  DirectionSampling direction = DirectionSampling::kBsdf;
  DirectLight direct = DirectLight::kMis;
};

/// Every mode, in the order of the button cycle.
std::span<const Mode> modes();
/// The mode of that key, or nullptr.
const Mode* find_mode(std::string_view key);

}  // namespace vitrine
