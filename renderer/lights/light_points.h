// How a point of a light is found. Lecture: "Direct Illumination - One Light".
#pragma once

#include <cstdint>

namespace vitrine {

enum class LightPoints : std::uint8_t {
  kArea,        ///< uniformly by area
  kSolidAngle,  ///< uniformly by the solid angle that the receiver sees
};

}  // namespace vitrine
