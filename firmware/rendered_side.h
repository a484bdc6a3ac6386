// A picture that was rendered to the end: as a picture of its own, or as a side of a comparison.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "json_output.h"
#include "picture.h"
#include "technique.h"

namespace vitrine {

struct RenderedSide {
  Technique technique;
  std::unique_ptr<Picture> picture;
  double seconds = 0.0;         ///< of tracing
  std::optional<double> error;  ///< relative, 1 being 100 %
};

/// How a picture begins when nothing of it is traced yet; must not outlive `scene` and `workers`.
RenderedSide begin_side(const Technique& technique, const BakedScene& scene, RenderOptions options,
                        Workers& workers);

/// Adds `spp` samples a pixel. Tells how far it is on stderr where somebody looks.
void trace_samples(RenderedSide& side, std::uint32_t spp);

/// Adds samples, at least one a pixel and at most `most_spp`, until the tracing took as near to `seconds` as
/// whole samples allow.
void trace_seconds(RenderedSide& side, double seconds, std::uint32_t most_spp);

/// How it was made and what came of it.
Json figures(const RenderedSide& side);

/// One line about samples that were dropped; empty if none was.
std::string dropped_line(const RenderedSide& side);

}  // namespace vitrine
