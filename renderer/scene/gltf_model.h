// A glTF file as tinygltf understands it, after everything that JSON alone can say has been checked: types,
// ranges and references between its parts hold, so the code that builds on a GltfModel need not ask again.
// Buffers are in memory; images are read when a material first uses them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tiny_gltf.h>

#include "scene/gltf_file.h"

namespace vitrine {

struct GltfModel {
  GltfFile file;
  tinygltf::Model model;
  std::vector<std::string> image_uris;  ///< of each image; empty: it is in a buffer view
  std::vector<std::string> notes;       ///< what was ignored, for Scene::notes

  /// Adds a note once.
  void note(const std::string& text);
};

/// Throws InputError.
GltfModel load_gltf_model(const std::filesystem::path& path);

}  // namespace vitrine
