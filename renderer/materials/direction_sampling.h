// How the direction is chosen in which a path goes on. Lecture: "Indirect Illumination - Uniform Dist.", "-
// Cosine Dist.", "- BRDF Dist.", "- BRDF*Cosine Dist.": they differ in nothing but the variance. What they
// come to:
//
//   lobe            BRDF                                     BRDF x cosine
//   Lambert         1 / (2 pi), exactly                      cos / pi, exactly
//   GGX facets      D(h) h.z: all facets, but not G and F    D(h) G1(wo) wo.h: the facets that wo sees, but
//   not F Charlie sheen   1 / (2 pi)                               1 / (2 pi): it has no sampling of its own
//
// A delta lobe can only be met by sampling it, so each of the four gives it its share of the samples.
#pragma once

#include <cstdint>

namespace vitrine {

enum class DirectionSampling : std::uint8_t {
  kUniform,    ///< all directions alike, over the sphere where a rough surface transmits
  kCosine,     ///< by |cosine|, likewise
  kBrdf,       ///< in proportion to the BRDF, as nearly as it can be
  kBrdfCosine  ///< in proportion to BRDF times cosine
};

}  // namespace vitrine
