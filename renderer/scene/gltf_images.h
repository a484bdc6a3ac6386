// The images of a glTF file, decoded by stb (PNG, JPEG) when a material first uses them, and halved until
// they fit the limits. Each image is kept once, however many textures show it.
#pragma once

#include <vector>

#include "scene/gltf_model.h"
#include "scene/scene.h"

namespace vitrine {

class GltfImages {
 public:
  explicit GltfImages(GltfModel& gltf) : gltf_(gltf), index_(gltf.model.images.size(), -1) {}

  /// The index in `images()` of /images/IMAGE.
  int use(int image);

  std::vector<Image> take() { return std::move(images_); }

 private:
  std::vector<unsigned char> encoded(std::size_t image, const std::string& place) const;
  Image decoded(const std::vector<unsigned char>& bytes, const std::string& place);

  GltfModel& gltf_;
  std::vector<int> index_;
  std::vector<Image> images_;
  std::uint64_t texels_ = 0;
};

}  // namespace vitrine
