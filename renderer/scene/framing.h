// A camera for a scene that has none: a three-quarter view (from the front, the right and above) that just
// holds the sphere around the scene's bounds, whatever the shape of the picture.
#pragma once

#include "geometry/bounds.h"
#include "scene/scene.h"

namespace vitrine {

/// The box around all instances, in world space, metres.
Bounds world_bounds(const Scene& scene);

/// A perspective camera named "auto" that sees all of `bounds`.
CameraView framing_camera(const Bounds& bounds);

}  // namespace vitrine
