// Triangles of a glTF mesh: lists, strips and fans, indexed or not, with the vertices that they use and no
// others (many primitives may share one long vertex buffer). Degenerate triangles, which strips are stitched
// with, are dropped.
#pragma once

#include <optional>

#include "scene/gltf_accessors.h"
#include "scene/gltf_model.h"
#include "scene/scene.h"

namespace vitrine {

/// Reads /meshes/MESH/primitives/PRIMITIVE; nothing if it has no triangles. Primitive::material is left to
/// the caller.
std::optional<Primitive> read_gltf_primitive(GltfModel& gltf, GltfAccessors& accessors, int mesh,
                                             int primitive);

}  // namespace vitrine
