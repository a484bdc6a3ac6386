// From what a file describes to what is traced: flattens instances, scales lengths and light, builds the
// hierarchy and the lights. On the host's arithmetic; only its result belongs to the number system.
#pragma once

#include "scene/camera.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace vitrine {

/// Instantiated for both number systems in bake.cpp. Throws InputError when the scene does not fit.
template <class N>
World<N> bake_world(const Scene& scene);

/// One of the scene's cameras, for a film of width x height pixels. What the camera promises to show (its
/// aspect) stays visible whatever the film's shape.
template <class N>
Camera<N> bake_camera(const CameraView& view, const World<N>& world, int width, int height);

}  // namespace vitrine
