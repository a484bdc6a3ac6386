#include "loaded_scene.h"

#include <numbers>

#include "built_in_scene.h"
#include "scene/gltf_import.h"
#include "scene/hdr_file.h"

namespace vitrine {
namespace {

void light(Scene& scene, const EnvironmentChoice& choice) {
  scene.environment_picture = read_hdr(choice.file);
  scene.environment_picture->nits = choice.nits;
  scene.environment_picture->rotation_rad = choice.rotation_deg * std::numbers::pi / 180.0;
}

}  // namespace

std::shared_ptr<const LoadedScene> load_scene(const PlaylistScene& scene, Numbers numbers) {
  Scene imported = is_built_in(scene) ? built_in_scene() : import_gltf(scene.file);
  if (scene.environment) {
    light(imported, *scene.environment);
  } else if (scene.default_environment && imported.has_default_light) {
    light(imported, *scene.default_environment);
  }
  auto loaded = std::make_shared<LoadedScene>();
  for (const CameraView& camera : imported.cameras) loaded->cameras.push_back(camera.name);
  loaded->baked = bake(imported, numbers);
  return loaded;
}

}  // namespace vitrine
