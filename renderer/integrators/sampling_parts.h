// The parts of which a way of sampling is made. A mode is a named choice of them, a parameter changes one.
#pragma once

#include <cstdint>
#include <string_view>

#include "integrators/stopping_rule.h"
#include "lights/light_points.h"
#include "lights/light_selection.h"
#include "materials/direction_sampling.h"
#include "sampling/mis.h"
#include "sampling/sequence.h"

namespace vitrine {

/// How a vertex collects light that comes straight from a source.
enum class DirectLight : std::uint8_t {
  kByChance,   ///< only when a scattered ray happens to hit the source
  kNextEvent,  ///< next event estimation: shadow rays to sampled points of sources
  kMis,        ///< both, weighted by multiple importance sampling
};

struct SamplingParts {
  DirectionSampling direction = DirectionSampling::kBrdfCosine;
  DirectLight direct = DirectLight::kMis;
  LightSelection lights = LightSelection::kUniform;
  LightPoints light_points = LightPoints::kArea;
  MisHeuristic heuristic = MisHeuristic::kPower;
  StoppingRule stop{};
  Sequence sequence = Sequence::kRandom;
  int shadow_rays = 1;       ///< a vertex; with LightSelection::kAll split over the lights, at least one each
  int radiance_samples = 1;  ///< directions in which a path goes on from each vertex

  bool operator==(const SamplingParts&) const = default;
};

/// Why the mean of infinitely many samples is not the true picture; empty: it is.
constexpr std::string_view bias(const SamplingParts& parts) {
  if (parts.sequence == Sequence::kGrid) return "the grid misses what lies between its points";
  if (parts.stop.kind == StoppingRule::Kind::kFixedDepth) return "longer paths are missing";
  return "";
}

}  // namespace vitrine
