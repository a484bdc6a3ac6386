// One fault at a time put into a file that is otherwise right: each is refused with its place.
#include "scene/gltf_scratch.h"

namespace vitrine {
namespace {

struct Fault {
  const char* member;   ///< JSON pointer of what is replaced
  json value;           ///< null: the member is removed
  const char* message;  ///< how the message goes on after "FILE: "
};

class GltfRefusalsTest : public GltfTest, public testing::WithParamInterface<int> {};

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all{
      {"/extensionsRequired",
       {"KHR_mesh_quantization", "ACME_magic"},
       "/extensionsRequired/1: the extension ACME_magic is not supported"},
      {"/extensionsRequired",
       {"KHR_draco_mesh_compression"},
       "/extensionsRequired/0: the extension KHR_draco_mesh_compression is not supported"},
      {"/extensionsRequired",
       {"EXT_meshopt_compression"},
       "/extensionsRequired/0: the extension EXT_meshopt_compression is not supported"},
      {"/asset/minVersion", "2.1", "/asset/minVersion: \"2.1\" is not 2.0"},
      {"/scene", 1, "/scene: refers to /scenes/1, but there are 1 of them"},
      {"/scene", "0", "/scene: is string where an integer belongs"},
      {"/scenes/0/nodes/0", 9, "/scenes/0/nodes/0: refers to /nodes/9"},
      {"/scenes/0/nodes", json::array(), "/scenes/0: the scene has no triangles"},
      {"/nodes/0", {{"mesh", 77}}, "/nodes/0/mesh: refers to /meshes/77, but there are 1 of them"},
      {"/nodes/0/mesh", -1, "/nodes/0/mesh: refers to /meshes/-1"},
      {"/nodes/0/mesh", 0.5, "/nodes/0/mesh: is 0.5 where an integer belongs"},
      {"/nodes/0/children", {4}, "/nodes/0/children/0: refers to /nodes/4"},
      {"/nodes/0/scale", {1, 2}, "/nodes/0/scale: has 2 numbers, not 3"},
      {"/nodes/0/scale", {1, "2", 3}, "/nodes/0/scale/1: is string where a number belongs"},
      {"/nodes/0/translation", {1e300, 0, 0}, "/nodes/0/translation/0: the number is too large for a float"},
      {"/nodes/0/rotation", {0, 0, 0, 0}, "/nodes/0/rotation: the quaternion is zero"},
      {"/nodes/0/matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "/nodes/0/matrix: its last row"},
      {"/meshes/0/primitives", nullptr, "/meshes/0: \"primitives\" is missing"},
      {"/meshes/0/primitives/0/attributes", nullptr, "/meshes/0/primitives/0: \"attributes\" is missing"},
      {"/meshes/0/primitives/0/attributes/a~1b", 5,
       "/meshes/0/primitives/0/attributes/a~1b: refers to /accessors/5"},
      {"/meshes/0/primitives/0/attributes/POSITION", 1,
       "/meshes/0/primitives/0/attributes/POSITION: accessor 1 has 1 components where 3 belong"},
      {"/meshes/0/primitives/0/attributes/NORMAL", 2,
       "/meshes/0/primitives/0/attributes/NORMAL: has 2 elements for 3"},
      {"/meshes/0/primitives/0/indices", 0,
       "/meshes/0/primitives/0/indices: accessor 0 does not hold unsigned integers"},
      {"/meshes/0/primitives/0/material", 0, "/meshes/0/primitives/0/material: refers to /materials/0"},
      {"/meshes/0/primitives/0/mode", 7, "/meshes/0/primitives/0/mode: 7 is more than 6"},
      {"/accessors/0/bufferView", 3, "/accessors/0/bufferView: refers to /bufferViews/3"},
      {"/accessors/0/count", 4, "/accessors/0: its 4 elements end at byte 48 of buffer view 0, which has 36"},
      {"/accessors/0/count", 0, "/accessors/0/count: 0 is less than 1"},
      {"/accessors/0/count", 1e9, "/accessors/0/count: more than 24000000 elements"},
      {"/accessors/0/count", 1e12, "/accessors/0/count: is 1000000000000.0 where an integer belongs"},
      {"/accessors/0/byteOffset", 4, "/accessors/0: its 3 elements end at byte 40"},
      {"/accessors/0/byteOffset", -4, "/accessors/0/byteOffset: -4 is less than 0"},
      {"/accessors/0/componentType", 5124, "/accessors/0/componentType: \"5124\" is none of 5120|5121"},
      {"/accessors/0/type", "VEC5", "/accessors/0/type: \"VEC5\" is none of SCALAR|"},
      {"/accessors/0/sparse", json::object(), "/accessors/0/sparse: \"count\" is missing"},
      {"/bufferViews/0/buffer", 1, "/bufferViews/0/buffer: refers to /buffers/1"},
      {"/bufferViews/0/byteLength", 1000, "/bufferViews/0: ends at byte 1000 of a buffer of"},
      {"/bufferViews/0/byteStride", 8, "/bufferViews/0/byteStride: 8 is less than an element of 12 bytes"},
      {"/buffers/0/byteLength", 0, "/buffers/0/byteLength: 0 is less than 1"},
      {"/buffers/0/byteLength", 1000000, "/buffers/0/byteLength: is 1000000, but there are only"},
      {"/buffers/0/byteLength", 2000000000, "/buffers/0/byteLength: the buffers hold more than 1024 MiB"},
      {"/buffers/0/uri", 5, "/buffers/0/uri: is 5 where a string belongs"},
      {"/buffers/0/uri", nullptr, "/buffers/0: the buffer has no data"},
      {"/nodes", json::object(), "/nodes: is object where an array belongs"},
      {"/images", json::array({json::object()}), "/images/0: an image has a uri or a bufferView"},
      {"/cameras", json::array({{{"type", "perspective"}}}), "/cameras/0: the type is perspective, but"},
      {"/cameras", json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 0}, {"znear", 1}}}}}),
       "/cameras/0/perspective/yfov: 0 is less than"},
      {"/samplers", json::array({{{"wrapS", 1}}}), "/samplers/0/wrapS: \"1\" is none of"},
      {"/materials", json::array({{{"pbrMetallicRoughness", {{"metallicFactor", 2}}}}}),
       "/materials/0/pbrMetallicRoughness/metallicFactor: 2 is more than 1"},
      {"/materials", json::array({{{"emissiveTexture", {{"index", 0}}}}}),
       "/materials/0/emissiveTexture/index: refers to /textures/0"},
      {"/materials", json::array({{{"alphaMode", "GLASS"}}}),
       "/materials/0/alphaMode: \"GLASS\" is none of OPAQUE|MASK|BLEND"},
      {"/materials", json::array({{{"alphaCutoff", -0.5}}}), "/materials/0/alphaCutoff: -0.5 is less than 0"},
      {"/materials", json::array({{{"normalTexture", {{"index", 0}}}}}),
       "/materials/0/normalTexture/index: refers to /textures/0"},
      {"/materials",
       json::array({{{"extensions", {{"KHR_materials_volume", {{"attenuationDistance", 0}}}}}}}),
       "/materials/0/extensions/KHR_materials_volume/attenuationDistance: 0 is less than"},
      {"/materials",
       json::array({{{"extensions", {{"KHR_materials_volume", {{"attenuationColor", {0, 2, 0}}}}}}}}),
       "/materials/0/extensions/KHR_materials_volume/attenuationColor/1: 2 is more than 1"},
      {"/meshes/0/primitives/0/attributes",
       {{"POSITION", 0}, {"NORMAL", 0}, {"TANGENT", 0}},
       "/meshes/0/primitives/0/attributes/TANGENT: accessor 0 has 3 components where 4 belong"},
      {"/materials", json::array({{{"doubleSided", 1}}}),
       "/materials/0/doubleSided: is 1 where true or false belongs"},
  };
  return all;
}

TEST_P(GltfRefusalsTest, IsRefusedWithItsPlace) {
  const Fault& fault = faults()[static_cast<std::size_t>(GetParam())];
  GltfDocument document = triangle_document();
  document.add_accessor({{"componentType", kFloat}, {"type", "VEC3"}, {"count", 2}});
  document.root["buffers"][0]["byteLength"] = document.bytes.size();
  ASSERT_NO_THROW(import(document));

  const json::json_pointer member(fault.member);
  if (fault.value.is_null()) {
    document.root[member.parent_pointer()].erase(member.back());
  } else {
    document.root[member] = fault.value;
  }
  const std::string message = refusal(document);
  EXPECT_EQ(message.rfind(fault.message, 0), 0U) << message;
}

INSTANTIATE_TEST_SUITE_P(EveryFault, GltfRefusalsTest, testing::Range(0, static_cast<int>(faults().size())));

}  // namespace
}  // namespace vitrine
