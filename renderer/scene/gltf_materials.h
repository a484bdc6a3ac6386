// glTF materials: metallic-roughness with the extensions that vitrine reads, and the textures that they use
// with sampler and KHR_texture_transform. What is left out of a material becomes a note.
#pragma once

#include <vector>

#include "scene/gltf_images.h"
#include "scene/gltf_model.h"
#include "scene/scene.h"

namespace vitrine {

class GltfMaterials {
 public:
  explicit GltfMaterials(GltfModel& gltf)
      : gltf_(gltf), images_(gltf), index_(gltf.model.materials.size(), -1) {}

  /// The index in the scene of /materials/MATERIAL; -1 stands for glTF's default material and stays -1.
  int use(int material);

  const std::vector<Material>& materials() const { return materials_; }
  /// Whether the material of that index is KHR_materials_unlit: it emits, but is not meant as a lamp.
  bool is_unlit(int index) const { return unlit_[static_cast<std::size_t>(index)]; }

  void move_into(Scene& scene);

 private:
  Material read(const tinygltf::Material& source, const std::string& place);
  TextureUse read_texture(const tinygltf::TextureInfo& info, const std::string& place);
  void read_extensions(const tinygltf::Material& source, const std::string& place, Material& material);
  void read_layers(const tinygltf::Material& source, const std::string& place, Material& material);
  static void read_alpha(const tinygltf::Material& source, Material& material);

  GltfModel& gltf_;
  GltfImages images_;
  std::vector<int> index_;
  std::vector<Material> materials_;
  std::vector<bool> unlit_;
};

}  // namespace vitrine
