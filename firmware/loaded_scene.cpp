#include "loaded_scene.h"

#include "scene/gltf_import.h"

namespace vitrine {

std::shared_ptr<const LoadedScene> load_scene(const PlaylistScene& scene, Numbers numbers) {
  const Scene imported = import_gltf(scene.file);
  auto loaded = std::make_shared<LoadedScene>();
  for (const CameraView& camera : imported.cameras) loaded->cameras.push_back(camera.name);
  loaded->baked = bake(imported, numbers);
  return loaded;
}

}  // namespace vitrine
