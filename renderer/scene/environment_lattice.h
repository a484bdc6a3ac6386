// From an equirectangular picture to the lattice of an EnvironmentMap: each texel is spread over the points
// around it, as each point weighs in the bilinear blend. So all light arrives, and as much as was sent.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace vitrine {

struct EnvironmentLattice {
  int cells = 0;                     ///< a side
  std::vector<glm::dvec3> radiance;  ///< nits, as EnvironmentMap takes them
};

/// As many cells as the picture has columns, rounded down to a power of two, 32 to 512. The flux of each
/// channel is that of the picture, an even picture stays even.
EnvironmentLattice make_environment_lattice(const EnvironmentPicture& picture);

}  // namespace vitrine
