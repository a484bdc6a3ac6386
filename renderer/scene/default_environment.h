// The sky over a scene that has no light of its own: no punctual light, no environment, no material that
// emits (a textured emission of at most 1 nit is not counted). An evenly bright overcast with a slightly blue
// zenith and a warm grey ground.
#pragma once

#include "scene/scene.h"

namespace vitrine {

inline constexpr Environment kDefaultEnvironment{
    {600.0F, 750.0F, 1000.0F}, {1000.0F, 1000.0F, 1000.0F}, {350.0F, 330.0F, 300.0F}};

}  // namespace vitrine
