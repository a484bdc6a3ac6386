// glTF 2.0 (.gltf with files or data URIs, .glb) into a Scene.
#pragma once

#include <filesystem>

#include "scene/scene.h"

namespace vitrine {

/// Reads `path`. Every reference, size and index of the file is checked before it is used; what vitrine does
/// not support but can ignore becomes a line in Scene::notes. Throws InputError when the file cannot be
/// rendered.
Scene import_gltf(const std::filesystem::path& path);

}  // namespace vitrine
