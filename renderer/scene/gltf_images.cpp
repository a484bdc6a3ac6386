#include "scene/gltf_images.h"

#include <algorithm>
#include <cstring>
#include <memory>

#include <stb_image.h>

#include "scene/gltf_limits.h"

namespace vitrine {
namespace {

// A format that is common in glTF files but not decoded here, by the first bytes of its files; nullptr: none
// of them.
const char* foreign_format(const std::vector<unsigned char>& bytes) {
  if (bytes.size() >= 12 && std::memcmp(bytes.data(), "RIFF", 4) == 0 &&
      std::memcmp(&bytes[8], "WEBP", 4) == 0) {
    return "WebP";
  }
  if (bytes.size() >= 12 && std::memcmp(bytes.data(), "\xABKTX 20\xBB", 8) == 0) return "KTX2";
  if (bytes.size() >= 4 && std::memcmp(bytes.data(), "DDS ", 4) == 0) return "DDS";
  return nullptr;
}

// Each texel of the result is the mean of a 2x2 block; an odd last row or column is repeated.
Image halved(const Image& image) {
  Image half{(image.width + 1) / 2, (image.height + 1) / 2, {}};
  const auto texel = [&](int x, int y, int channel) {
    const auto row = static_cast<std::size_t>(std::min(y, image.height - 1));
    const auto column = static_cast<std::size_t>(std::min(x, image.width - 1));
    return unsigned{image.rgba[(row * static_cast<std::size_t>(image.width) + column) * 4 +
                               static_cast<std::size_t>(channel)]};
  };
  half.rgba.reserve(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height) * 4);
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (int c = 0; c < 4; ++c) {
        const unsigned sum = texel(2 * x, 2 * y, c) + texel(2 * x + 1, 2 * y, c) +
                             texel(2 * x, 2 * y + 1, c) + texel(2 * x + 1, 2 * y + 1, c);
        half.rgba.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
      }
    }
  }
  return half;
}

}  // namespace

int GltfImages::use(int image) {
  const auto i = static_cast<std::size_t>(image);
  if (index_[i] >= 0) return index_[i];
  const std::string place = "/images/" + std::to_string(image);
  Image result = decoded(encoded(i, place), place);
  texels_ += static_cast<std::uint64_t>(result.width) * static_cast<std::uint64_t>(result.height);
  if (texels_ > gltf_limits::kMaxTexels) {
    gltf_.file.refuse(place,
                      "the images hold more than " + std::to_string(gltf_limits::kMaxTexels) + " texels",
                      "use smaller textures");
  }
  images_.push_back(std::move(result));
  index_[i] = static_cast<int>(images_.size()) - 1;
  return index_[i];
}

std::vector<unsigned char> GltfImages::encoded(std::size_t image, const std::string& place) const {
  const auto& described = gltf_.model.images[image];
  if (described.bufferView < 0) return gltf_.file.read_uri(gltf_.image_uris[image], place + "/uri");
  const auto& view = gltf_.model.bufferViews[static_cast<std::size_t>(described.bufferView)];
  const auto& data = gltf_.model.buffers[static_cast<std::size_t>(view.buffer)].data;
  const auto first = data.begin() + static_cast<std::ptrdiff_t>(view.byteOffset);
  return {first, first + static_cast<std::ptrdiff_t>(view.byteLength)};
}

Image GltfImages::decoded(const std::vector<unsigned char>& bytes, const std::string& place) {
  if (const char* format = foreign_format(bytes)) {
    gltf_.file.refuse(place, std::string(format) + " images are not supported", "convert it to PNG or JPEG");
  }
  Image image;
  int channels = 0;
  const auto size = static_cast<int>(bytes.size());
  const bool known = stbi_info_from_memory(bytes.data(), size, &image.width, &image.height, &channels) != 0;
  const auto texels = static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
  if (known && texels > gltf_limits::kMaxImageTexels) {
    gltf_.file.refuse(
        place, std::to_string(image.width) + "x" + std::to_string(image.height) + " texels are too many",
        "use a smaller texture");
  }
  const std::unique_ptr<stbi_uc, void (*)(void*)> rgba(
      known
          ? stbi_load_from_memory(bytes.data(), size, &image.width, &image.height, &channels, STBI_rgb_alpha)
          : nullptr,
      stbi_image_free);
  if (!rgba) {
    const char* reason = stbi_failure_reason();
    gltf_.file.refuse(place,
                      std::string("the image cannot be decoded (") + (reason ? reason : "unknown") + ")",
                      "store it as PNG or JPEG again");
  }
  image.rgba.assign(rgba.get(), rgba.get() + texels * 4);
  if (std::max(image.width, image.height) > gltf_limits::kMaxImageSide) {
    gltf_.note(place + " shrunk: a side is longer than " + std::to_string(gltf_limits::kMaxImageSide) +
               " texels");
  }
  while (std::max(image.width, image.height) > gltf_limits::kMaxImageSide) image = halved(image);
  return image;
}

}  // namespace vitrine
