#include "command_info.h"

#include <iostream>

#include "exit_status.h"
#include "json_output.h"
#include "playlist.h"
#include "scene/gltf_import.h"

namespace vitrine {
namespace {

std::size_t count_triangles(const Scene& scene) {
  std::size_t triangles = 0;
  for (const Instance& instance : scene.instances) {
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
      triangles += primitive.triangles.size();
    }
  }
  return triangles;
}

std::size_t count_emitting_materials(const Scene& scene) {
  std::size_t emitting = 0;
  for (const Material& material : scene.materials) emitting += material.emission != glm::vec3(0.0F) ? 1U : 0U;
  return emitting;
}

const char* kind_name(PunctualKind kind) {
  switch (kind) {
    case PunctualKind::kPoint:
      return "point";
    case PunctualKind::kSpot:
      return "spot";
    case PunctualKind::kDirectional:
      break;
  }
  return "directional";
}

/// Everything that is told, for people line by line and for programs as it is.
Json describe(const Scene& scene, const std::filesystem::path& file) {
  Json cameras = Json::array();
  for (const CameraView& camera : scene.cameras) {
    cameras.push_back(
        {{"name", camera.name}, {"kind", camera.orthographic ? "orthographic" : "perspective"}});
  }
  Json lights = Json::array();
  for (const PunctualLight& light : scene.lights) {
    lights.push_back({{"name", light.name}, {"kind", kind_name(light.kind)}});
  }
  return {{"file", file.string()},
          {"name", scene.name},
          {"triangles", count_triangles(scene)},
          {"meshes", scene.meshes.size()},
          {"instances", scene.instances.size()},
          {"materials", scene.materials.size()},
          {"emitting_materials", count_emitting_materials(scene)},
          {"images", scene.images.size()},
          {"cameras", cameras},
          {"lights", lights},
          {"environment", scene.environment || scene.environment_picture},
          {"notes", scene.notes}};
}

void print_text(const Json& description) {
  for (const auto& [key, value] : description.items()) {
    if (!value.is_array()) {
      std::cout << key << ": " << (value.is_string() ? value.get<std::string>() : value.dump()) << '\n';
      continue;
    }
    std::cout << key << ':' << (value.empty() ? " none\n" : "\n");
    for (const Json& entry : value) {
      if (entry.is_string()) {
        std::cout << "  " << entry.get<std::string>() << '\n';
      } else {
        std::cout << "  " << entry["kind"].get<std::string>() << " '" << entry["name"].get<std::string>()
                  << "'\n";
      }
    }
  }
}

}  // namespace

int execute(const InfoRequest& request) {
  const PlaylistScene scene = resolve_scene(request.scene, find_playlist(request.playlist));
  const Json description = describe(import_gltf(scene.file), scene.file);
  if (request.json) {
    print_json(description);
  } else {
    print_text(description);
  }
  return kDone;
}

}  // namespace vitrine
