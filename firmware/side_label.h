// What the label over a picture says of how it was made.
#pragma once

#include <cstdint>
#include <optional>

#include "hud.h"
#include "technique.h"

namespace vitrine {

/// `beside`: what it is compared with, if anything.
inline HudSide side_label(const Technique& technique, const Technique* beside, std::uint32_t samples,
                          std::optional<double> error) {
  return {.mode = std::string(technique.mode->label),
          .changes = describe_changes(technique, beside),
          .bias = std::string(bias(technique.parts)),
          .samples_per_pixel = samples,
          .error = error};
}

}  // namespace vitrine
