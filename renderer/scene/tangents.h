// Tangents for a normal map, where the file gives none: along growing u, blended over the triangles that
// share a vertex by their angles there, as MikkTSpace does (Mikkelsen 2008). A vertex that a triangle with
// mirrored texture coordinates shares with one without becomes two, since their bitangents differ in sign.
#pragma once

#include "scene/scene.h"

namespace vitrine {

/// The primitive with tangents for the texture coordinates of `normal_map`. Without normals, every triangle
/// gets vertices of its own. A tangent is (0,0,0) where the coordinates do not tell a direction.
Primitive with_tangents(Primitive primitive, const TextureUse& normal_map);

}  // namespace vitrine
