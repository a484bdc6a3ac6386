// The ways to sample a scene whose means must agree: every unbiased mode, and every unbiased value of each
// parameter, set in a mode that heeds it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "integrators/modes.h"
#include "integrators/parameters.h"

namespace vitrine {

struct Way {
  std::string name;
  SamplingParts parts;
};

inline std::vector<Way> mode_ways() {
  std::vector<Way> ways;
  for (const Mode& mode : modes()) {
    if (bias(mode.parts).empty()) ways.push_back({std::string(mode.key), mode.parts});
  }
  return ways;
}

/// By every value that the parameter's button offers, but for the mode's own.
inline std::vector<Way> parameter_ways(const Parameter& parameter) {
  std::vector<Way> ways;
  const Mode& mode = *find_mode("mis");
  for (const std::string_view value : parameter.cycle) {
    Way way{std::string(mode.key) + ' ' + std::string(parameter.name) + ' ' + std::string(value), mode.parts};
    if (parameter.set(way.parts, value) && bias(way.parts).empty() && way.parts != mode.parts) {
      ways.push_back(way);
    }
  }
  return ways;
}

/// Whether light without extent, which is never met by chance, reaches the picture.
inline bool sends_shadow_rays(const SamplingParts& parts) { return parts.direct != DirectLight::kByChance; }

/// As a test's name.
inline std::string test_name(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return c == '-' || c == ' ' || c == ':' || c == '.'; }, '_');
  return name;
}

}  // namespace vitrine
