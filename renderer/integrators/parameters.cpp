#include "integrators/parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <optional>

namespace vitrine {
namespace {

/// The whole of `text` as a number in [low, high].
template <class T>
std::optional<T> number(std::string_view text, T low, T high) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value >= low) || !(value <= high))
    return std::nullopt;
  return value;
}

/// A part that is one of some words.
template <class E>
struct Word {
  std::string_view word;
  E value;
};
template <class E, std::size_t Count>
bool set_word(const std::array<Word<E>, Count>& words, std::string_view word, E& value) {
  const auto found = std::ranges::find(words, word, &Word<E>::word);
  if (found == words.end()) return false;
  value = found->value;
  return true;
}
template <class E, std::size_t Count>
std::string show_word(const std::array<Word<E>, Count>& words, E value) {
  return std::string(std::ranges::find(words, value, &Word<E>::value)->word);
}

constexpr auto kDirections = std::to_array<Word<DirectionSampling>>({
    {"uniform", DirectionSampling::kUniform},
    {"cosine", DirectionSampling::kCosine},
    {"brdf", DirectionSampling::kBrdf},
    {"brdf-cosine", DirectionSampling::kBrdfCosine},
});
constexpr auto kLights = std::to_array<Word<LightSelection>>({
    {"uniform", LightSelection::kUniform},
    {"all", LightSelection::kAll},
    {"power", LightSelection::kPower},
    {"tree", LightSelection::kTree},
});
constexpr auto kLightPoints = std::to_array<Word<LightPoints>>({
    {"area", LightPoints::kArea},
    {"solid-angle", LightPoints::kSolidAngle},
});
constexpr auto kHeuristics = std::to_array<Word<MisHeuristic>>({
    {"balance", MisHeuristic::kBalance},
    {"power", MisHeuristic::kPower},
});
constexpr auto kSequences = std::to_array<Word<Sequence>>({
    {"random", Sequence::kRandom},
    {"grid", Sequence::kGrid},
    {"stratified", Sequence::kStratified},
    {"sobol", Sequence::kSobol},
    {"blue-noise", Sequence::kBlueNoise},
});

constexpr int kMaxShadowRays = 1024;
constexpr int kMaxRadianceSamples = 64;
constexpr int kMaxFixedDepth = 10'000;
constexpr double kLeastAlpha = 0.001;

bool set_stopping_rule(SamplingParts& parts, std::string_view text) {
  using Kind = StoppingRule::Kind;
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view name = text.substr(0, colon);
  const std::optional<std::string_view> value =
      colon < text.size() ? std::optional(text.substr(colon + 1)) : std::nullopt;
  StoppingRule rule;
  if (name == "fixed-depth" && value) {
    rule.kind = Kind::kFixedDepth;
    const auto depth = number(*value, 0, kMaxFixedDepth);
    if (!depth) return false;
    rule.depth = *depth;
  } else if (name == "constant" && value) {
    rule.kind = Kind::kConstant;
    const auto alpha = number(*value, kLeastAlpha, 1.0);
    if (!alpha) return false;
    rule.alpha_bits = static_cast<std::uint32_t>(std::min(*alpha * 0x1p32, 0x1p32 - 1.0));
  } else if (name == "reflectance" && !value) {
    rule.kind = Kind::kReflectance;
  } else if (name != "throughput" || value) {
    return false;
  }
  parts.stop = rule;
  return true;
}

std::string show_stopping_rule(const SamplingParts& parts) {
  switch (parts.stop.kind) {
    case StoppingRule::Kind::kFixedDepth:
      return "fixed-depth:" + std::to_string(parts.stop.depth);
    case StoppingRule::Kind::kConstant: {
      std::array<char, 32> text{};
      std::snprintf(text.data(), text.size(), "constant:%g", parts.stop.alpha_bits * 0x1p-32);
      return text.data();
    }
    case StoppingRule::Kind::kReflectance:
      return "reflectance";
    case StoppingRule::Kind::kThroughput:
      break;
  }
  return "throughput";
}

bool always(const SamplingParts& /*parts*/) { return true; }
bool with_shadow_rays(const SamplingParts& parts) { return parts.direct != DirectLight::kByChance; }
bool with_mis(const SamplingParts& parts) { return parts.direct == DirectLight::kMis; }

using Cycle = std::string_view;
constexpr auto kDirectionCycle = std::to_array<Cycle>({"uniform", "cosine", "brdf", "brdf-cosine"});
constexpr auto kLightCycle = std::to_array<Cycle>({"uniform", "all", "power", "tree"});
constexpr auto kLightPointCycle = std::to_array<Cycle>({"area", "solid-angle"});
constexpr auto kHeuristicCycle = std::to_array<Cycle>({"balance", "power"});
constexpr auto kStopCycle = std::to_array<Cycle>({"throughput", "reflectance", "constant:0.9", "constant:0.1",
                                                  "fixed-depth:1", "fixed-depth:2", "fixed-depth:4"});
constexpr auto kSequenceCycle = std::to_array<Cycle>({"random", "grid", "stratified", "sobol", "blue-noise"});
constexpr auto kShadowRayCycle = std::to_array<Cycle>({"1", "4", "16", "256"});
constexpr auto kRadianceSampleCycle = std::to_array<Cycle>({"1", "2", "4", "8"});

const auto kParameters = std::to_array<Parameter>({
    {"shadow-rays", "Shadow rays", "1", "N",
     "shadow rays at each vertex; with --lights all split over the lights, at least one each",
     kShadowRayCycle, with_shadow_rays,
     [](SamplingParts& parts, std::string_view value) {
       const auto n = number(value, 1, kMaxShadowRays);
       if (n) parts.shadow_rays = *n;
       return n.has_value();
     },
     [](const SamplingParts& parts) { return std::to_string(parts.shadow_rays); }},
    {"radiance-samples", "Radiance samples", "2", "N", "directions in which a path goes on at each vertex",
     kRadianceSampleCycle, always,
     [](SamplingParts& parts, std::string_view value) {
       const auto n = number(value, 1, kMaxRadianceSamples);
       if (n) parts.radiance_samples = *n;
       return n.has_value();
     },
     [](const SamplingParts& parts) { return std::to_string(parts.radiance_samples); }},
    {"roulette", "Roulette", "3", "fixed-depth:K|constant:ALPHA|reflectance|throughput",
     "when a path ends: after K scattering events (biased), or by Russian roulette: it goes on with the "
     "probability ALPHA, with what the surface reflects, or with what the path is still worth",
     kStopCycle, always, set_stopping_rule, show_stopping_rule},
    {"sequence", "Sequence", "4", "random|grid|stratified|sobol|blue-noise", "where samples are taken",
     kSequenceCycle, always,
     [](SamplingParts& parts, std::string_view value) { return set_word(kSequences, value, parts.sequence); },
     [](const SamplingParts& parts) { return show_word(kSequences, parts.sequence); }},
    {"directions", "Directions", "5", "uniform|cosine|brdf|brdf-cosine",
     "distribution of the directions in which a path goes on", kDirectionCycle, with_shadow_rays,
     [](SamplingParts& parts, std::string_view value) {
       return set_word(kDirections, value, parts.direction);
     },
     [](const SamplingParts& parts) { return show_word(kDirections, parts.direction); }},
    {"lights", "Lights", "6", "uniform|all|power|tree", "which lights the shadow rays go to", kLightCycle,
     with_shadow_rays,
     [](SamplingParts& parts, std::string_view value) { return set_word(kLights, value, parts.lights); },
     [](const SamplingParts& parts) { return show_word(kLights, parts.lights); }},
    {"light-points", "Light points", "7", "area|solid-angle", "how a point of an area light is found",
     kLightPointCycle, with_shadow_rays,
     [](SamplingParts& parts, std::string_view value) {
       return set_word(kLightPoints, value, parts.light_points);
     },
     [](const SamplingParts& parts) { return show_word(kLightPoints, parts.light_points); }},
    {"heuristic", "Heuristic", "8", "balance|power", "of multiple importance sampling", kHeuristicCycle,
     with_mis,
     [](SamplingParts& parts, std::string_view value) {
       return set_word(kHeuristics, value, parts.heuristic);
     },
     [](const SamplingParts& parts) { return show_word(kHeuristics, parts.heuristic); }},
});

}  // namespace

std::span<const Parameter> parameters() { return kParameters; }

const Parameter* find_parameter(std::string_view name) {
  const auto found = std::ranges::find(kParameters, name, &Parameter::name);
  return found == kParameters.end() ? nullptr : &*found;
}

}  // namespace vitrine
