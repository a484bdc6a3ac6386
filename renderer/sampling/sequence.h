// The sequences that samples are taken from. Lecture: "Monte Carlo vs. Deterministic Integration".
#pragma once

#include <cstdint>

namespace vitrine {

enum class Sequence : std::uint8_t {
  kRandom,      ///< independent random numbers
  kGrid,        ///< the midpoints of a regular grid, the same in every pixel: deterministic, biased
  kStratified,  ///< jittered strata
  kSobol,       ///< Owen-scrambled Sobol points
  kBlueNoise,   ///< Sobol points whose error is spread over the screen as blue noise
};

}  // namespace vitrine
