#include "rendered_side.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include <unistd.h>

namespace vitrine {
namespace {

/// A pass of `spp`, and how long it took.
double trace(RenderedSide& side, std::uint32_t spp) {
  const bool watched = isatty(STDERR_FILENO) != 0;
  const auto begin = std::chrono::steady_clock::now();
  side.picture->start_pass(spp);
  while (!side.picture->pass_ended(std::chrono::milliseconds(100))) {
    if (watched) std::fprintf(stderr, "\r%3.0f %%", 100.0 * side.picture->progress());
  }
  if (watched) std::fprintf(stderr, "\r     \r");
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

Json dropped_records(const TraceStats& stats) {
  Json records = Json::array();
  for (const DroppedSample& dropped : stats.dropped_samples) {
    records.push_back(
        {{"x", dropped.x}, {"y", dropped.y}, {"sample", dropped.sample}, {"seed", dropped.seed}});
  }
  return records;
}

Json parameter_values(const Technique& technique) {
  Json values = Json::object();
  for (const Parameter& parameter : parameters()) {
    if (parameter.belongs(technique.parts))
      values[std::string(parameter.name)] = parameter.show(technique.parts);
  }
  return values;
}

}  // namespace

RenderedSide begin_side(const Technique& technique, const BakedScene& scene, RenderOptions options,
                        Workers& workers) {
  options.mode = technique.mode;
  options.parts = technique.parts;
  return {technique, std::make_unique<Picture>(scene.make_renderer(options), workers), 0.0, std::nullopt};
}

void trace_samples(RenderedSide& side, std::uint32_t spp) {
  side.seconds += trace(side, spp);
  side.error = side.picture->error();
}

void trace_seconds(RenderedSide& side, double seconds, std::uint32_t most_spp) {
  side.seconds = trace(side, 1);
  while (side.picture->samples() < most_spp) {
    // Half of what seems to fit: the first passes tell little about how long a sample takes.
    const double a_sample = side.seconds / side.picture->samples();
    const double fit = (seconds - side.seconds) / a_sample;
    if (fit < 0.5) break;
    const double left = most_spp - side.picture->samples();
    side.seconds += trace(side, static_cast<std::uint32_t>(std::clamp(fit / 2.0, 1.0, left)));
  }
  side.error = side.picture->error();
}

Json figures(const RenderedSide& side) {
  const TraceStats& stats = side.picture->stats();
  return {{"mode", side.technique.mode->key},
          {"parameters", parameter_values(side.technique)},
          {"spp", side.picture->samples()},
          {"seconds", side.seconds},
          {"samples_per_s", static_cast<double>(stats.samples) / side.seconds},
          {"rays", stats.rays},
          {"rays_per_s", static_cast<double>(stats.rays) / side.seconds},
          {"error_percent", side.error ? Json(100.0 * *side.error) : Json(nullptr)},
          {"nonfinite_samples", stats.dropped},
          {"nonfinite_records", dropped_records(stats)}};
}

std::string dropped_line(const RenderedSide& side) {
  const TraceStats& stats = side.picture->stats();
  if (stats.dropped == 0) return "";
  const DroppedSample& first = stats.dropped_samples.front();
  return std::to_string(stats.dropped) + " samples dropped as not finite; see the first with --mode " +
         std::string(side.technique.mode->key) + " --pixel " + std::to_string(first.x) + "," +
         std::to_string(first.y) + " --sample " + std::to_string(first.sample) + " --seed " +
         std::to_string(first.seed);
}

}  // namespace vitrine
