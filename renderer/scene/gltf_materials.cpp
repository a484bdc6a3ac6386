#include "scene/gltf_materials.h"

#include <cmath>

namespace vitrine {
namespace {

using tinygltf::Value;

// An ior of 0 asks for total reflection (KHR_materials_ior); this one reflects 99.96 %.
constexpr float kIorOfTotalReflection = 1e4F;

// The members of an extension object. Their types have been checked.
class Members {
 public:
  Members(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto found = extensions.find(name);
    if (found != extensions.end()) object_ = &found->second;
  }

  explicit operator bool() const { return object_ != nullptr; }
  bool has(const char* key) const { return object_ != nullptr && object_->Has(key); }

  double number(const char* key, double otherwise) const {
    return has(key) ? object_->Get(key).GetNumberAsDouble() : otherwise;
  }

  template <int N>
  glm::vec<N, float> numbers(const char* key, glm::vec<N, float> otherwise) const {
    if (!has(key)) return otherwise;
    for (int i = 0; i < N; ++i)
      otherwise[i] = static_cast<float>(object_->Get(key).Get(i).GetNumberAsDouble());
    return otherwise;
  }

  tinygltf::TextureInfo texture(const char* key) const {
    tinygltf::TextureInfo info;
    if (!has(key)) return info;
    const Value& value = object_->Get(key);
    info.index = value.Get("index").GetNumberAsInt();
    if (value.Has("texCoord")) info.texCoord = value.Get("texCoord").GetNumberAsInt();
    if (value.Has("extensions")) {
      const Value& extensions = value.Get("extensions");
      for (const std::string& name : extensions.Keys()) info.extensions[name] = extensions.Get(name);
    }
    return info;
  }

 private:
  const Value* object_ = nullptr;
};

tinygltf::TextureInfo texture_info(const tinygltf::NormalTextureInfo& normal) {
  tinygltf::TextureInfo info;
  info.index = normal.index;
  info.texCoord = normal.texCoord;
  info.extensions = normal.extensions;
  return info;
}

glm::vec3 color_of(const std::vector<double>& values) {
  return {static_cast<float>(values[0]), static_cast<float>(values[1]), static_cast<float>(values[2])};
}

TextureWrap wrap_of(int mode) {
  if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return TextureWrap::kClampToEdge;
  if (mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return TextureWrap::kMirroredRepeat;
  return TextureWrap::kRepeat;
}

// Translation * rotation * scale. A positive angle turns u towards -v: counter-clockwise as an image is seen,
// whose v points down.
glm::mat3 uv_transform(const Members& transform) {
  const auto offset = transform.numbers<2>("offset", glm::vec2(0.0F));
  const auto scale = transform.numbers<2>("scale", glm::vec2(1.0F));
  const auto angle = static_cast<float>(transform.number("rotation", 0.0));
  const float c = std::cos(angle);
  const float s = std::sin(angle);
  return {glm::vec3(c, -s, 0.0F) * scale.x, glm::vec3(s, c, 0.0F) * scale.y, glm::vec3(offset, 1.0F)};
}

}  // namespace

int GltfMaterials::use(int material) {
  if (material < 0) return -1;
  const auto i = static_cast<std::size_t>(material);
  if (index_[i] < 0) {
    const auto& source = gltf_.model.materials[i];
    materials_.push_back(read(source, "/materials/" + std::to_string(material)));
    unlit_.push_back(source.extensions.count("KHR_materials_unlit") != 0);
    index_[i] = static_cast<int>(materials_.size()) - 1;
  }
  return index_[i];
}

void GltfMaterials::move_into(Scene& scene) {
  scene.materials = std::move(materials_);
  scene.images = images_.take();
}

Material GltfMaterials::read(const tinygltf::Material& source, const std::string& place) {
  const auto& pbr = source.pbrMetallicRoughness;
  Material material;
  material.name = one_line(source.name);
  material.base_color = color_of(pbr.baseColorFactor);
  material.base_color_texture =
      read_texture(pbr.baseColorTexture, place + "/pbrMetallicRoughness/baseColorTexture");
  material.double_sided = source.doubleSided;
  read_alpha(source, material);
  if (source.occlusionTexture.index >= 0) {
    gltf_.note(place + ": occlusionTexture ignored, occlusion is traced");
  }

  if (source.extensions.count("KHR_materials_unlit") != 0) {
    gltf_.note(place + " is unlit: shown as emission of its base colour, vertex colours left out");
    material.emission = material.base_color;
    material.emission_texture = material.base_color_texture;
    material.base_color = glm::vec3(0.0F);
    material.base_color_texture = {};
    material.metallic = 0.0F;
    material.specular = 0.0F;
    return material;
  }

  material.metallic = static_cast<float>(pbr.metallicFactor);
  material.roughness = static_cast<float>(pbr.roughnessFactor);
  material.metallic_roughness_texture =
      read_texture(pbr.metallicRoughnessTexture, place + "/pbrMetallicRoughness/metallicRoughnessTexture");
  material.emission = color_of(source.emissiveFactor);
  material.emission_texture = read_texture(source.emissiveTexture, place + "/emissiveTexture");
  material.normal_texture = read_texture(texture_info(source.normalTexture), place + "/normalTexture");
  material.normal_scale = static_cast<float>(source.normalTexture.scale);
  read_extensions(source, place, material);
  read_layers(source, place, material);
  return material;
}

void GltfMaterials::read_extensions(const tinygltf::Material& source, const std::string& place,
                                    Material& material) {
  const auto& extensions = source.extensions;
  const Members strength(extensions, "KHR_materials_emissive_strength");
  material.emission *= static_cast<float>(strength.number("emissiveStrength", 1.0));
  if (!(glm::length(glm::dvec3(material.emission)) < 1e12)) {
    gltf_.file.refuse(place, "emits more than 1e12 nits", "lower its emissiveStrength");
  }

  const Members ior(extensions, "KHR_materials_ior");
  const auto eta = static_cast<float>(ior.number("ior", 1.5));
  if (eta > 0.0F && eta < 1.0F) {
    gltf_.file.refuse(place + "/extensions/KHR_materials_ior/ior", "is between 0 and 1",
                      "use 0, or 1 and more");
  }
  material.ior = eta == 0.0F ? kIorOfTotalReflection : eta;

  const Members specular(extensions, "KHR_materials_specular");
  material.specular = static_cast<float>(specular.number("specularFactor", 1.0));
  material.specular_color = specular.numbers<3>("specularColorFactor", glm::vec3(1.0F));
  const std::string specular_place = place + "/extensions/KHR_materials_specular/";
  material.specular_texture =
      read_texture(specular.texture("specularTexture"), specular_place + "specularTexture");
  material.specular_color_texture =
      read_texture(specular.texture("specularColorTexture"), specular_place + "specularColorTexture");

  const Members transmission(extensions, "KHR_materials_transmission");
  material.transmission = static_cast<float>(transmission.number("transmissionFactor", 0.0));
  material.transmission_texture =
      read_texture(transmission.texture("transmissionTexture"),
                   place + "/extensions/KHR_materials_transmission/transmissionTexture");

  const Members volume(extensions, "KHR_materials_volume");
  material.refracts = volume.number("thicknessFactor", 0.0) > 0.0;
  material.attenuation_color = volume.numbers<3>("attenuationColor", glm::vec3(1.0F));
  if (volume.has("attenuationDistance")) {
    material.attenuation_distance = static_cast<float>(volume.number("attenuationDistance", 0.0));
  }
  if (volume.has("thicknessTexture")) {
    gltf_.note(place + ": thicknessTexture ignored, the way through the solid is traced");
  }
}

void GltfMaterials::read_layers(const tinygltf::Material& source, const std::string& place,
                                Material& material) {
  const Members sheen(source.extensions, "KHR_materials_sheen");
  const std::string sheen_place = place + "/extensions/KHR_materials_sheen/";
  material.sheen_color = sheen.numbers<3>("sheenColorFactor", glm::vec3(0.0F));
  material.sheen_color_texture =
      read_texture(sheen.texture("sheenColorTexture"), sheen_place + "sheenColorTexture");
  material.sheen_roughness = static_cast<float>(sheen.number("sheenRoughnessFactor", 0.0));
  material.sheen_roughness_texture =
      read_texture(sheen.texture("sheenRoughnessTexture"), sheen_place + "sheenRoughnessTexture");

  const Members coat(source.extensions, "KHR_materials_clearcoat");
  const std::string coat_place = place + "/extensions/KHR_materials_clearcoat/";
  material.clearcoat = static_cast<float>(coat.number("clearcoatFactor", 0.0));
  material.clearcoat_texture =
      read_texture(coat.texture("clearcoatTexture"), coat_place + "clearcoatTexture");
  material.clearcoat_roughness = static_cast<float>(coat.number("clearcoatRoughnessFactor", 0.0));
  material.clearcoat_roughness_texture =
      read_texture(coat.texture("clearcoatRoughnessTexture"), coat_place + "clearcoatRoughnessTexture");
  if (coat.has("clearcoatNormalTexture")) {
    gltf_.note(place + ": clearcoatNormalTexture ignored, the coat follows the surface");
  }
  if (material.clearcoat > 0.0F && material.emission != glm::vec3(0.0F)) {
    gltf_.note(place + ": what it emits is not dimmed by its clear coat");
  }
}

void GltfMaterials::read_alpha(const tinygltf::Material& source, Material& material) {
  if (source.alphaMode == "OPAQUE") return;
  material.alpha_mode = source.alphaMode == "MASK" ? AlphaMode::kMask : AlphaMode::kBlend;
  material.alpha = static_cast<float>(source.pbrMetallicRoughness.baseColorFactor[3]);
  material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
  material.alpha_texture = material.base_color_texture;
}

TextureUse GltfMaterials::read_texture(const tinygltf::TextureInfo& info, const std::string& place) {
  TextureUse use;
  if (info.index < 0) return use;
  const auto& texture = gltf_.model.textures[static_cast<std::size_t>(info.index)];
  if (texture.source < 0) {
    gltf_.note(place + " ignored: its texture has no PNG or JPEG image");
    return use;
  }
  const Members transform(info.extensions, "KHR_texture_transform");
  use.texcoord = static_cast<int>(transform.number("texCoord", info.texCoord));
  if (use.texcoord > 1) {
    gltf_.note(place + " ignored: only the texture coordinate sets 0 and 1 are read");
    return {};
  }
  use.transform = uv_transform(transform);
  if (texture.sampler >= 0) {
    const auto& sampler = gltf_.model.samplers[static_cast<std::size_t>(texture.sampler)];
    use.wrap_s = wrap_of(sampler.wrapS);
    use.wrap_t = wrap_of(sampler.wrapT);
    use.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  }
  use.image = images_.use(texture.source);
  return use;
}

}  // namespace vitrine
