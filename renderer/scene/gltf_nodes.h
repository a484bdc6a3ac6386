// The node hierarchy of a glTF scene: a forest, walked once. Each node's local transform (matrix, or
// translation * rotation * scale) is multiplied to its parent's; meshes, EXT_mesh_gpu_instancing copies,
// cameras and KHR_lights_punctual lights are placed where their node ends up.
#pragma once

#include <vector>

#include "scene/gltf_accessors.h"
#include "scene/gltf_model.h"
#include "scene/scene.h"

namespace vitrine {

struct GltfPlacements {
  struct Mesh {
    int mesh;  ///< of the file
    int node;  ///< of the file
    glm::dmat4 to_world;
  };
  std::vector<Mesh> meshes;
  std::vector<CameraView> cameras;
  std::vector<PunctualLight> lights;
};

/// Index of the scene that is shown: `scene`, else the first; -1: the file lists none and all its nodes are
/// shown.
int default_gltf_scene(const tinygltf::Model& model);

/// Refuses a node with two parents, a cycle, a scene that lists a child, and transforms that are not finite.
GltfPlacements place_gltf_nodes(GltfModel& gltf, GltfAccessors& accessors);

}  // namespace vitrine
