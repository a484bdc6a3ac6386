// What the selection of lights has to know of the lights of a baked world, read off the world itself.
#pragma once

#include <vector>

#include "scene/world.h"

namespace vitrine {

/// Of every light, by its index in world.lights. In baked units of length and radiance. Instantiated for both
/// number systems in light_emissions.cpp.
template <class N>
std::vector<LightEmission> light_emissions(const World<N>& world);

}  // namespace vitrine
