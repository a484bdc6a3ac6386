#include "scene/gltf_extensions.h"

#include <algorithm>
#include <string_view>

#include <nlohmann/json.hpp>

namespace vitrine {
namespace {

using nlohmann::json;

struct Extension {
  std::string_view name;
  std::string_view ignored;  ///< what is done instead; empty: the extension is read
  bool may_be_required;      ///< the picture is a right one even so
};

constexpr Extension kExtensions[] = {
    {"KHR_lights_punctual", "", true},
    {"KHR_materials_clearcoat", "", true},
    {"KHR_materials_emissive_strength", "", true},
    {"KHR_materials_ior", "", true},
    {"KHR_materials_sheen", "", true},
    {"KHR_materials_specular", "", true},
    {"KHR_materials_transmission", "", true},
    {"KHR_materials_unlit", "", true},
    {"KHR_materials_volume", "", true},
    {"KHR_mesh_quantization", "", true},
    {"KHR_texture_transform", "", true},
    {"EXT_mesh_gpu_instancing", "", true},

    {"KHR_animation_pointer", "nothing is animated", true},
    {"KHR_materials_variants", "the materials of the default variant are used", true},
    {"KHR_xmp_json_ld", "it describes the file only", true},

    {"EXT_meshopt_compression", "the uncompressed fallback is used", false},
    {"EXT_texture_webp", "the PNG or JPEG fallback is used where there is one", false},
    {"KHR_draco_mesh_compression", "the uncompressed fallback is used", false},
    {"KHR_materials_pbrSpecularGlossiness", "the metallic-roughness fallback is used", false},
    {"KHR_meshopt_compression", "the uncompressed fallback is used", false},
    {"KHR_texture_basisu", "the PNG or JPEG fallback is used where there is one", false},
};

const Extension* find_extension(const std::string& name) {
  const auto* found = std::find_if(std::begin(kExtensions), std::end(kExtensions),
                                   [&](const Extension& extension) { return extension.name == name; });
  return found == std::end(kExtensions) ? nullptr : found;
}

// The strings of an array of the root; its other elements are the schema's to refuse.
std::vector<std::string> names_in(const json& document, const char* key) {
  std::vector<std::string> names;
  if (!document.contains(key) || !document[key].is_array()) return names;
  for (const json& name : document[key]) names.push_back(name.is_string() ? name.get<std::string>() : "");
  return names;
}

void check_version(const GltfFile& file, const json& document) {
  const json::json_pointer version_place("/asset/version");
  if (!document.contains(version_place) || !document[version_place].is_string()) {
    file.refuse("/asset/version", "the version of glTF is not given as a string",
                "export the file as glTF 2.0");
  }
  for (const char* key : {"version", "minVersion"}) {
    const json& asset = document["asset"];
    if (!asset.contains(key)) continue;
    const std::string version = asset[key].is_string() ? asset[key].get<std::string>() : "";
    const bool is_2_x = version.size() > 2 && version.compare(0, 2, "2.") == 0 &&
                        version.find_first_not_of("0123456789", 2) == std::string::npos;
    const bool asks_for_more = std::string_view(key) == "minVersion" && version != "2.0";
    if (!is_2_x || asks_for_more) {
      file.refuse(std::string("/asset/") + key, "\"" + version + "\" is not 2.0",
                  "export the file as glTF 2.0");
    }
  }
}

}  // namespace

void check_gltf_extensions(const GltfFile& file, const json& document, std::vector<std::string>& notes) {
  check_version(file, document);
  const auto required = names_in(document, "extensionsRequired");
  for (std::size_t i = 0; i < required.size(); ++i) {
    const Extension* extension = find_extension(required[i]);
    if (extension == nullptr || !extension->may_be_required) {
      file.refuse("/extensionsRequired/" + std::to_string(i),
                  "the extension " + required[i] + " is not supported", "export the file without it");
    }
  }
  for (const std::string& name : names_in(document, "extensionsUsed")) {
    const Extension* extension = find_extension(name);
    if (extension == nullptr) {
      notes.push_back("extension " + one_line(name) + " ignored: vitrine does not know it");
    } else if (!extension->ignored.empty()) {
      notes.push_back("extension " + name + " ignored: " + std::string(extension->ignored));
    }
  }
}

}  // namespace vitrine
