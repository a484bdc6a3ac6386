// The members of a glTF 2.0 document that vitrine reads: one row each, with the type, the range or the target
// that the specification gives it. To read another member, add its row.
#pragma once

#include <cfloat>
#include <cstddef>
#include <string_view>

namespace vitrine::gltf_schema {

enum class Kind {
  kObject,
  kClosedObject,  // an object that may hold listed members only
  kMap,           // an object whose keys are free; its values follow the rule PATH/*
  kExtras,        // anything; kept and checked if it is an object
  kArray,
  kIndex,
  kInteger,
  kNumber,
  kNumbers,
  kString,
  kBoolean,
  kShared,  // an object whose members are listed under another path
};

struct Check {
  Kind kind;
  double min = 0;
  double max = 0;
  std::size_t count = 0;  // kNumbers: how many
  std::string_view text =
      "";  // kIndex: the collection; kString, kInteger: what is permitted; kShared: the path
};

struct Rule {
  std::string_view path;  // '*' stands for an array index or a free key
  Check check;
  bool required = false;
};

constexpr double kMaxInteger = 2147483647;
constexpr double kHalfPi = 1.5707963267948966;
constexpr double kTiny = 1e-9;
constexpr bool kRequired = true;

constexpr Check kObject{Kind::kObject};
constexpr Check kArray{Kind::kArray};
constexpr Check kString{Kind::kString};
constexpr Check kBoolean{Kind::kBoolean};
constexpr Check kFactor{Kind::kNumber, 0, 1};
constexpr Check kTextureInfo{Kind::kShared, 0, 0, 0, "TextureInfo"};
constexpr Check kOffset{Kind::kInteger, 0, kMaxInteger};

constexpr Check index_of(std::string_view collection) { return {Kind::kIndex, 0, 0, 0, collection}; }
constexpr Check one_of(std::string_view values) { return {Kind::kString, 0, 0, 0, values}; }
constexpr Check one_of_integers(std::string_view values) {
  return {Kind::kInteger, 0, kMaxInteger, 0, values};
}
constexpr Check integer(double min, double max = kMaxInteger) { return {Kind::kInteger, min, max}; }
constexpr Check number(double min = -FLT_MAX, double max = FLT_MAX) { return {Kind::kNumber, min, max}; }
constexpr Check numbers(std::size_t count, double min = -FLT_MAX, double max = FLT_MAX) {
  return {Kind::kNumbers, min, max, count};
}

// A row a member.
constexpr Rule kRules[] = {
    {"asset", kObject, kRequired},
    {"asset/version", kString, kRequired},
    {"extensionsUsed", kArray},
    {"extensionsUsed/*", kString},
    {"scene", index_of("scenes")},

    {"buffers", kArray},
    {"buffers/*", kObject},
    {"buffers/*/uri", kString},
    {"buffers/*/byteLength", integer(1), kRequired},

    {"bufferViews", kArray},
    {"bufferViews/*", kObject},
    {"bufferViews/*/buffer", index_of("buffers"), kRequired},
    {"bufferViews/*/byteOffset", kOffset},
    {"bufferViews/*/byteLength", integer(1), kRequired},
    {"bufferViews/*/byteStride", integer(4, 252)},

    {"accessors", kArray},
    {"accessors/*", kObject},
    {"accessors/*/bufferView", index_of("bufferViews")},
    {"accessors/*/byteOffset", kOffset},
    {"accessors/*/componentType", one_of_integers("|5120|5121|5122|5123|5125|5126|"), kRequired},
    {"accessors/*/normalized", kBoolean},
    {"accessors/*/count", integer(1), kRequired},
    {"accessors/*/type", one_of("|SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4|"), kRequired},
    {"accessors/*/sparse", kObject},
    {"accessors/*/sparse/count", integer(1), kRequired},
    {"accessors/*/sparse/indices", kObject, kRequired},
    {"accessors/*/sparse/indices/bufferView", index_of("bufferViews"), kRequired},
    {"accessors/*/sparse/indices/byteOffset", kOffset},
    {"accessors/*/sparse/indices/componentType", one_of_integers("|5121|5123|5125|"), kRequired},
    {"accessors/*/sparse/values", kObject, kRequired},
    {"accessors/*/sparse/values/bufferView", index_of("bufferViews"), kRequired},
    {"accessors/*/sparse/values/byteOffset", kOffset},

    {"meshes", kArray},
    {"meshes/*", kObject},
    {"meshes/*/name", kString},
    {"meshes/*/primitives", kArray, kRequired},
    {"meshes/*/primitives/*", kObject},
    {"meshes/*/primitives/*/attributes", {Kind::kMap}, kRequired},
    {"meshes/*/primitives/*/attributes/*", index_of("accessors")},
    {"meshes/*/primitives/*/indices", index_of("accessors")},
    {"meshes/*/primitives/*/material", index_of("materials")},
    {"meshes/*/primitives/*/mode", integer(0, 6)},
    {"meshes/*/primitives/*/targets", kArray},
    {"meshes/*/primitives/*/targets/*", {Kind::kMap}},
    {"meshes/*/primitives/*/targets/*/*", index_of("accessors")},

    {"nodes", kArray},
    {"nodes/*", kObject},
    {"nodes/*/name", kString},
    {"nodes/*/children", kArray},
    {"nodes/*/children/*", index_of("nodes")},
    {"nodes/*/matrix", numbers(16)},
    {"nodes/*/translation", numbers(3)},
    {"nodes/*/rotation", numbers(4, -1.001, 1.001)},
    {"nodes/*/scale", numbers(3)},
    {"nodes/*/mesh", index_of("meshes")},
    {"nodes/*/skin", index_of("skins")},
    {"nodes/*/camera", index_of("cameras")},
    {"nodes/*/extensions", kObject},
    {"nodes/*/extensions/KHR_lights_punctual", kObject},
    {"nodes/*/extensions/KHR_lights_punctual/light", index_of("extensions/KHR_lights_punctual/lights"),
     kRequired},
    {"nodes/*/extensions/EXT_mesh_gpu_instancing", kObject},
    {"nodes/*/extensions/EXT_mesh_gpu_instancing/attributes", {Kind::kMap}, kRequired},
    {"nodes/*/extensions/EXT_mesh_gpu_instancing/attributes/*", index_of("accessors")},

    {"scenes", kArray},
    {"scenes/*", kObject},
    {"scenes/*/name", kString},
    {"scenes/*/nodes", kArray},
    {"scenes/*/nodes/*", index_of("nodes")},
    {"scenes/*/extras", {Kind::kExtras}},
    {"scenes/*/extras/vitrine", {Kind::kClosedObject}},
    {"scenes/*/extras/vitrine/environment", {Kind::kClosedObject}},
    {"scenes/*/extras/vitrine/environment/zenith", numbers(3, 0)},
    {"scenes/*/extras/vitrine/environment/horizon", numbers(3, 0)},
    {"scenes/*/extras/vitrine/environment/ground", numbers(3, 0)},
    {"scenes/*/extras/vitrine/environment/image", kString},
    {"scenes/*/extras/vitrine/environment/nits", number(kTiny, 1e9)},
    {"scenes/*/extras/vitrine/environment/rotation", number(-360, 360)},

    {"cameras", kArray},
    {"cameras/*", kObject},
    {"cameras/*/name", kString},
    {"cameras/*/type", one_of("|perspective|orthographic|"), kRequired},
    {"cameras/*/perspective", kObject},
    {"cameras/*/perspective/yfov", number(1e-4, 3.1415), kRequired},
    {"cameras/*/perspective/aspectRatio", number(1e-4, 1e4)},
    {"cameras/*/perspective/znear", number(0), kRequired},
    {"cameras/*/orthographic", kObject},
    {"cameras/*/orthographic/xmag", number(), kRequired},
    {"cameras/*/orthographic/ymag", number(), kRequired},
    {"cameras/*/orthographic/znear", number(), kRequired},
    {"cameras/*/orthographic/zfar", number(), kRequired},

    {"extensions", kObject},
    {"extensions/KHR_lights_punctual", kObject},
    {"extensions/KHR_lights_punctual/lights", kArray, kRequired},
    {"extensions/KHR_lights_punctual/lights/*", kObject},
    {"extensions/KHR_lights_punctual/lights/*/name", kString},
    {"extensions/KHR_lights_punctual/lights/*/type", one_of("|point|spot|directional|"), kRequired},
    {"extensions/KHR_lights_punctual/lights/*/color", numbers(3, 0)},
    {"extensions/KHR_lights_punctual/lights/*/intensity", number(0)},
    {"extensions/KHR_lights_punctual/lights/*/range", number(kTiny)},
    {"extensions/KHR_lights_punctual/lights/*/spot", kObject},
    {"extensions/KHR_lights_punctual/lights/*/spot/innerConeAngle", number(0, kHalfPi)},
    {"extensions/KHR_lights_punctual/lights/*/spot/outerConeAngle", number(kTiny, kHalfPi + 1e-6)},

    {"samplers", kArray},
    {"samplers/*", kObject},
    {"samplers/*/magFilter", one_of_integers("|9728|9729|")},
    {"samplers/*/wrapS", one_of_integers("|10497|33071|33648|")},
    {"samplers/*/wrapT", one_of_integers("|10497|33071|33648|")},

    {"images", kArray},
    {"images/*", kObject},
    {"images/*/uri", kString},
    {"images/*/mimeType", kString},
    {"images/*/bufferView", index_of("bufferViews")},

    {"textures", kArray},
    {"textures/*", kObject},
    {"textures/*/sampler", index_of("samplers")},
    {"textures/*/source", index_of("images")},

    {"TextureInfo/index", index_of("textures"), kRequired},
    {"TextureInfo/texCoord", integer(0)},
    {"TextureInfo/scale", number()},
    {"TextureInfo/strength", kFactor},
    {"TextureInfo/extensions", kObject},
    {"TextureInfo/extensions/KHR_texture_transform", kObject},
    {"TextureInfo/extensions/KHR_texture_transform/offset", numbers(2)},
    {"TextureInfo/extensions/KHR_texture_transform/rotation", number()},
    {"TextureInfo/extensions/KHR_texture_transform/scale", numbers(2)},
    {"TextureInfo/extensions/KHR_texture_transform/texCoord", integer(0)},

    {"materials", kArray},
    {"materials/*", kObject},
    {"materials/*/name", kString},
    {"materials/*/doubleSided", kBoolean},
    {"materials/*/alphaMode", one_of("|OPAQUE|MASK|BLEND|")},
    {"materials/*/alphaCutoff", number(0)},
    {"materials/*/pbrMetallicRoughness", kObject},
    {"materials/*/pbrMetallicRoughness/baseColorFactor", numbers(4, 0, 1)},
    {"materials/*/pbrMetallicRoughness/baseColorTexture", kTextureInfo},
    {"materials/*/pbrMetallicRoughness/metallicFactor", kFactor},
    {"materials/*/pbrMetallicRoughness/roughnessFactor", kFactor},
    {"materials/*/pbrMetallicRoughness/metallicRoughnessTexture", kTextureInfo},
    {"materials/*/normalTexture", kTextureInfo},
    {"materials/*/occlusionTexture", kTextureInfo},
    {"materials/*/emissiveTexture", kTextureInfo},
    {"materials/*/emissiveFactor", numbers(3, 0, 1)},
    {"materials/*/extensions", kObject},
    {"materials/*/extensions/KHR_materials_unlit", kObject},
    {"materials/*/extensions/KHR_materials_emissive_strength", kObject},
    {"materials/*/extensions/KHR_materials_emissive_strength/emissiveStrength", number(0)},
    {"materials/*/extensions/KHR_materials_ior", kObject},
    {"materials/*/extensions/KHR_materials_ior/ior", number(0)},
    {"materials/*/extensions/KHR_materials_specular", kObject},
    {"materials/*/extensions/KHR_materials_specular/specularFactor", kFactor},
    {"materials/*/extensions/KHR_materials_specular/specularTexture", kTextureInfo},
    {"materials/*/extensions/KHR_materials_specular/specularColorFactor", numbers(3, 0)},
    {"materials/*/extensions/KHR_materials_specular/specularColorTexture", kTextureInfo},
    {"materials/*/extensions/KHR_materials_sheen", kObject},
    {"materials/*/extensions/KHR_materials_sheen/sheenColorFactor", numbers(3, 0, 1)},
    {"materials/*/extensions/KHR_materials_sheen/sheenColorTexture", kTextureInfo},
    {"materials/*/extensions/KHR_materials_sheen/sheenRoughnessFactor", kFactor},
    {"materials/*/extensions/KHR_materials_sheen/sheenRoughnessTexture", kTextureInfo},
    {"materials/*/extensions/KHR_materials_clearcoat", kObject},
    {"materials/*/extensions/KHR_materials_clearcoat/clearcoatFactor", kFactor},
    {"materials/*/extensions/KHR_materials_clearcoat/clearcoatTexture", kTextureInfo},
    {"materials/*/extensions/KHR_materials_clearcoat/clearcoatRoughnessFactor", kFactor},
    {"materials/*/extensions/KHR_materials_clearcoat/clearcoatRoughnessTexture", kTextureInfo},
    {"materials/*/extensions/KHR_materials_clearcoat/clearcoatNormalTexture", kTextureInfo},
    {"materials/*/extensions/KHR_materials_transmission", kObject},
    {"materials/*/extensions/KHR_materials_transmission/transmissionFactor", kFactor},
    {"materials/*/extensions/KHR_materials_transmission/transmissionTexture", kTextureInfo},
    {"materials/*/extensions/KHR_materials_volume", kObject},
    {"materials/*/extensions/KHR_materials_volume/thicknessFactor", number(0)},
    {"materials/*/extensions/KHR_materials_volume/thicknessTexture", kTextureInfo},
    {"materials/*/extensions/KHR_materials_volume/attenuationDistance", number(kTiny)},
    {"materials/*/extensions/KHR_materials_volume/attenuationColor", numbers(3, 0, 1)},

    {"skins", kArray},
    {"skins/*", kObject},
    {"animations", kArray},
    {"animations/*", kObject},
};

}  // namespace vitrine::gltf_schema
