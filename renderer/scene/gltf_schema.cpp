#include "scene/gltf_schema.h"

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string_view>

#include <nlohmann/json.hpp>

namespace vitrine {
namespace {

using nlohmann::json;

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
      "";  // kIndex: the collection; kString, kInteger: permitted values; kShared: the path
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
    {"scenes/*/extras/vitrine/environment/zenith", numbers(3, 0), kRequired},
    {"scenes/*/extras/vitrine/environment/horizon", numbers(3, 0), kRequired},
    {"scenes/*/extras/vitrine/environment/ground", numbers(3, 0), kRequired},

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

std::string parent_of(std::string_view path) {
  const auto slash = path.rfind('/');
  return std::string(slash == std::string_view::npos ? "" : path.substr(0, slash));
}

std::string trimmed(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
}

// RFC 6901
std::string pointer_token(const std::string& key) {
  std::string token;
  for (const char c : key) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return token;
}

class SchemaWalk {
 public:
  SchemaWalk(const GltfFile& file, const json& root) : file_(file) {
    for (const Rule& rule : kRules) {
      rules_.emplace(rule.path, &rule);
      if (rule.required)
        required_[parent_of(rule.path)].push_back(rule.path.substr(rule.path.rfind('/') + 1));
      if (rule.check.kind == Kind::kIndex) sizes_.emplace(rule.check.text, size_of(root, rule.check.text));
    }
  }

  /// `path` is where the table lists the members of `object`, `place` where it is.
  void check_members(json& object, const std::string& path, const std::string& place, bool closed = false) {
    for (const std::string_view key : required_[path]) {
      if (!object.contains(key)) refuse(place, "\"" + std::string(key) + "\" is missing");
    }
    for (auto member = object.begin(); member != object.end();) {
      const std::string member_path = path.empty() ? member.key() : path + "/" + member.key();
      const std::string member_place = place + "/" + pointer_token(member.key());
      const auto rule = rules_.find(member_path);
      if (rule != rules_.end()) {
        check(member.value(), *rule->second, member_place);
        ++member;
      } else if (closed) {
        refuse(member_place, "is not known");
      } else {
        member = object.erase(member);
      }
    }
  }

 private:
  static std::size_t size_of(const json& root, std::string_view collection) {
    const json::json_pointer pointer("/" + std::string(collection));
    if (!root.contains(pointer)) return 0;
    const json& array = root[pointer];
    return array.is_array() ? array.size() : 0;
  }

  void check(json& value, const Rule& rule, const std::string& place) {
    const std::string path(rule.path);
    switch (rule.check.kind) {
      case Kind::kObject:
        return check_object(value, path, place, false);
      case Kind::kClosedObject:
        return check_object(value, path, place, true);
      case Kind::kShared:
        return check_object(value, std::string(rule.check.text), place, false);
      case Kind::kMap:
        expect(value.is_object(), value, "an object", place);
        return check_elements(value, path, place);
      case Kind::kExtras:
        if (value.is_object()) return check_members(value, path, place);
        value = json::object();
        return;
      case Kind::kArray:
        expect(value.is_array(), value, "an array", place);
        return check_elements(value, path, place);
      case Kind::kIndex:
        return check_index(value, rule.check.text, place);
      case Kind::kInteger:
        return check_integer(value, rule.check, place);
      case Kind::kNumber:
        return check_number(value, rule.check, place);
      case Kind::kNumbers:
        return check_numbers(value, rule.check, place);
      case Kind::kString:
        return check_string(value, rule.check, place);
      case Kind::kBoolean:
        return expect(value.is_boolean(), value, "true or false", place);
    }
  }

  void check_object(json& value, const std::string& path, const std::string& place, bool closed) {
    expect(value.is_object(), value, "an object", place);
    check_members(value, path, place, closed);
  }

  void check_elements(json& value, const std::string& path, const std::string& place) {
    const Rule& rule = *rules_.at(path + "/*");
    if (value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) check(value[i], rule, place + "/" + std::to_string(i));
    } else {
      for (auto& [key, element] : value.items()) check(element, rule, place + "/" + pointer_token(key));
    }
  }

  void check_integer(json& value, const Check& limits, const std::string& place) {
    // JSON has one number type: 5.0 is an integer too.
    if (value.is_number_float() && std::floor(value.get<double>()) == value.get<double>() &&
        std::abs(value.get<double>()) <= kMaxInteger) {
      value = static_cast<std::int64_t>(value.get<double>());
    }
    expect(value.is_number_integer(), value, "an integer", place);
    check_range(value.get<double>(), limits, place);
    check_permitted(value.dump(), limits, place);
  }

  void check_index(json& value, std::string_view collection, const std::string& place) {
    const std::size_t size = sizes_.at(std::string(collection));
    check_integer(value, integer(-FLT_MAX, FLT_MAX), place);
    const double index = value.get<double>();
    if (index < 0 || index >= static_cast<double>(size)) {
      refuse(place, "refers to /" + std::string(collection) + "/" + value.dump() + ", but there are " +
                        std::to_string(size) + " of them");
    }
  }

  void check_number(json& value, const Check& limits, const std::string& place) {
    expect(value.is_number(), value, "a number", place);
    check_range(value.get<double>(), limits, place);
    value = value.get<double>();
  }

  void check_numbers(json& value, const Check& limits, const std::string& place) {
    expect(value.is_array(), value, "an array of numbers", place);
    if (value.size() != limits.count) {
      refuse(place, "has " + std::to_string(value.size()) + " numbers, not " + std::to_string(limits.count));
    }
    for (std::size_t i = 0; i < value.size(); ++i)
      check_number(value[i], limits, place + "/" + std::to_string(i));
  }

  void check_string(const json& value, const Check& permitted, const std::string& place) {
    expect(value.is_string(), value, "a string", place);
    check_permitted(value.get_ref<const std::string&>(), permitted, place);
  }

  void check_permitted(const std::string& value, const Check& permitted, const std::string& place) {
    if (permitted.text.empty() || permitted.text.find("|" + value + "|") != std::string_view::npos) return;
    refuse(place, "\"" + value + "\" is none of " +
                      std::string(permitted.text.substr(1, permitted.text.size() - 2)));
  }

  void check_range(double value, const Check& limits, const std::string& place) {
    if (value >= limits.min && value <= limits.max) return;
    const bool below = value < limits.min;
    const double limit = below ? limits.min : limits.max;
    refuse(place, std::abs(limit) >= FLT_MAX
                      ? "the number is too large for a float"
                      : trimmed(value) + (below ? " is less than " : " is more than ") + trimmed(limit));
  }

  void expect(bool as_expected, const json& value, const char* expected, const std::string& place) {
    if (!as_expected)
      refuse(place, std::string("is ") + value.type_name() + " where " + expected + " belongs");
  }

  [[noreturn]] void refuse(const std::string& place, const std::string& problem) {
    file_.refuse(place, problem, "correct the file or export it again");
  }

  const GltfFile& file_;
  std::map<std::string, const Rule*, std::less<>> rules_;
  std::map<std::string, std::vector<std::string_view>, std::less<>> required_;
  std::map<std::string, std::size_t, std::less<>> sizes_;
};

}  // namespace

void check_gltf_schema(const GltfFile& file, json& document) {
  SchemaWalk(file, document).check_members(document, "", "");
}

}  // namespace vitrine
