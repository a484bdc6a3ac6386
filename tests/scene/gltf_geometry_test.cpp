// Triangles and vertex attributes in every form in which accessors may hold them.
#include <cstdint>

#include "scene/gltf_scratch.h"

namespace vitrine {
namespace {

using GltfGeometryTest = GltfTest;

const std::vector<float> kSquare{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

json primitive_of(const GltfDocument&, json attributes) { return {{"attributes", std::move(attributes)}}; }

glm::vec3 normal_of(const Primitive& primitive, std::size_t triangle) {
  const glm::uvec3 t = primitive.triangles.at(triangle);
  const auto& p = primitive.positions;
  return glm::normalize(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]));
}

template <class T>
GltfDocument indexed_square(int component_type) {
  GltfDocument document;
  json primitive = primitive_of(document, {{"POSITION", document.add_positions(kSquare)}});
  primitive["indices"] = document.add_accessor(std::vector<T>{0, 1, 2, 0, 2, 3}, component_type, "SCALAR", 6);
  document.add_mesh_node(primitive);
  return document;
}

TEST_F(GltfGeometryTest, ReadsIndicesOfEveryWidth) {
  for (const GltfDocument& document :
       {indexed_square<std::uint8_t>(kUnsignedByte), indexed_square<std::uint16_t>(kUnsignedShort),
        indexed_square<std::uint32_t>(kUnsignedInt)}) {
    const Scene scene = import(document);
    const Primitive& primitive = only_primitive(scene);
    ASSERT_EQ(primitive.triangles.size(), 2U);
    EXPECT_EQ(primitive.positions.size(), 4U);
    EXPECT_EQ(primitive.positions[primitive.triangles[1].z], glm::vec3(0, 1, 0));
    EXPECT_TRUE(primitive.normals.empty());
  }
}

TEST_F(GltfGeometryTest, StripsAndFansKeepTheirFacing) {
  for (const int mode : {5, 6}) {
    GltfDocument document;
    const std::vector<float> strip{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};
    const std::vector<float> fan{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 1, 0};
    json primitive = primitive_of(document, {{"POSITION", document.add_positions(mode == 5 ? strip : fan)}});
    primitive["mode"] = mode;
    document.add_mesh_node(primitive);
    const Scene scene = import(document);
    ASSERT_EQ(only_primitive(scene).triangles.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(normal_of(only_primitive(scene), i), glm::vec3(0, 0, 1)) << mode;
  }
}

TEST_F(GltfGeometryTest, ReadsInterleavedVertices) {
  GltfDocument document;
  // Position, normal, texture coordinates: 32 bytes a vertex, after 8 bytes of something else.
  std::vector<float> bytes{9, 9};
  for (std::size_t i = 0; i < 4; ++i) {
    bytes.insert(bytes.end(), {kSquare[3 * i], kSquare[3 * i + 1], kSquare[3 * i + 2], 0, 0, 2, 0.25F, 0.5F});
  }
  const int view = document.add_view(bytes);
  document.root["bufferViews"][0]["byteStride"] = 32;
  const auto at = [&](int offset, const char* type) {
    return document.add_accessor({{"bufferView", view},
                                  {"byteOffset", 8 + offset},
                                  {"componentType", kFloat},
                                  {"type", type},
                                  {"count", 4}});
  };
  json primitive = primitive_of(
      document, {{"POSITION", at(0, "VEC3")}, {"NORMAL", at(12, "VEC3")}, {"TEXCOORD_1", at(24, "VEC2")}});
  primitive["mode"] = 6;
  document.add_mesh_node(primitive);
  const Scene scene = import(document);
  const Primitive& read = only_primitive(scene);
  ASSERT_EQ(read.positions.size(), 4U);
  EXPECT_EQ(read.positions[read.triangles[0].y], glm::vec3(1, 1, 0));
  EXPECT_EQ(read.normals[2], glm::vec3(0, 0, 1)) << "normals are made unit length";
  EXPECT_TRUE(read.uv[0].empty());
  EXPECT_EQ(read.uv[1][3], glm::vec2(0.25F, 0.5F));
}

TEST_F(GltfGeometryTest, ReadsNormalisedAndQuantisedIntegers) {
  GltfDocument document;
  const int positions = document.add_accessor(
      std::vector<std::int16_t>{0, 0, 0, 0, 300, 0, 0, 0, 0, -400, 0, 0}, kShort, "VEC3", 3);
  document.root["bufferViews"].back()["byteStride"] = 8;
  const int normals = document.add_accessor(
      std::vector<std::int8_t>{0, 0, 127, 0, 0, 0, -128, 0, 0, 0, 127, 0}, kByte, "VEC3", 3);
  document.root["bufferViews"].back()["byteStride"] = 4;
  document.root["accessors"].back()["normalized"] = true;
  const int uv =
      document.add_accessor(std::vector<std::uint16_t>{0, 65535, 32768, 0, 0, 0}, kUnsignedShort, "VEC2", 3);
  document.root["accessors"].back()["normalized"] = true;
  const int colors = document.add_accessor(
      std::vector<std::uint8_t>{255, 0, 51, 255, 255, 255, 255, 0, 0, 0, 0, 0}, kUnsignedByte, "VEC4", 3);
  document.root["accessors"].back()["normalized"] = true;
  document.root["extensionsRequired"] = {"KHR_mesh_quantization"};
  document.add_mesh_node(
      {{"attributes",
        {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uv}, {"COLOR_0", colors}}}});
  const Scene scene = import(document);
  const Primitive& read = only_primitive(scene);
  EXPECT_EQ(read.positions[1], glm::vec3(300, 0, 0));
  EXPECT_EQ(read.positions[2], glm::vec3(0, -400, 0));
  EXPECT_EQ(read.normals[1], glm::vec3(0, 0, -1)) << "-128 is -1 too";
  EXPECT_EQ(read.uv[0][0], glm::vec2(0, 1));
  EXPECT_NEAR(read.uv[0][1].x, 32768.0 / 65535.0, 1e-7);
  EXPECT_NEAR(read.colors[0].z, 0.2, 1e-7);
}

// Tangents are made for the normals beside them.
TEST_F(GltfGeometryTest, ReadsTangentsWhereThereAreNormals) {
  GltfDocument document = triangle_document();
  const int normals = document.add_positions({0, 0, 1, 0, 0, 1, 0, 0, 1});
  const int tangents =
      document.add_accessor(std::vector<float>{1, 0, 0, -1, 0, 1, 0, 1, 1, 0, 0, 1}, kFloat, "VEC4", 3);
  json& attributes = document.root["meshes"][0]["primitives"][0]["attributes"];
  attributes["TANGENT"] = tangents;
  EXPECT_TRUE(only_primitive(import(document)).tangents.empty());
  attributes["NORMAL"] = normals;
  const Scene scene = import(document);
  ASSERT_EQ(only_primitive(scene).tangents.size(), 3U);
  EXPECT_EQ(only_primitive(scene).tangents[0], glm::vec4(1, 0, 0, -1));
  EXPECT_EQ(only_primitive(scene).tangents[1], glm::vec4(0, 1, 0, 1));
}

TEST_F(GltfGeometryTest, ReadsTheAlphaOfColours) {
  GltfDocument document = triangle_document();
  json& attributes = document.root["meshes"][0]["primitives"][0]["attributes"];
  const auto alphas = [&](const std::vector<float>& rgba) {
    attributes["COLOR_0"] = document.add_accessor(rgba, kFloat, "VEC4", 3);
    return only_primitive(import(document)).alphas;
  };
  EXPECT_EQ(alphas({1, 1, 1, 0.25F, 1, 1, 1, 1, 1, 1, 1, 7}), (std::vector<float>{0.25F, 1, 1}));
  EXPECT_TRUE(alphas({1, 1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 1}).empty()) << "1 everywhere is no alpha";
  EXPECT_EQ(only_primitive(import(document)).colors[1], glm::vec3(1, 0, 1));
}

GltfDocument sparse_document() {
  GltfDocument document = triangle_document();
  const int indices = document.add_view(std::vector<std::uint8_t>{2});
  const int values = document.add_view(std::vector<float>{0, 5, 0});
  document.root["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", indices}, {"componentType", kUnsignedByte}}},
      {"values", {{"bufferView", values}}}};
  return document;
}

TEST_F(GltfGeometryTest, SubstitutesSparseElements) {
  const Scene scene = import(sparse_document());
  EXPECT_EQ(only_primitive(scene).positions[2], glm::vec3(0, 5, 0));
  EXPECT_EQ(only_primitive(scene).positions[1], glm::vec3(1, 0, 0));

  GltfDocument zeros = sparse_document();
  zeros.root["accessors"][0].erase("bufferView");
  EXPECT_NE(refusal(zeros).find("no triangles"), std::string::npos) << "the others are zero";
}

TEST_F(GltfGeometryTest, RefusesSparseElementsOutOfRange) {
  GltfDocument document = sparse_document();
  document.root["accessors"][0]["count"] = 2;
  document.root["meshes"][0]["primitives"][0].erase("indices");
  const std::string message = refusal(document);
  EXPECT_NE(message.find("/accessors/0/sparse/indices: substitutes element 2 of 2"), std::string::npos)
      << message;
}

TEST_F(GltfGeometryTest, KeepsOnlyWhatTrianglesUse) {
  GltfDocument document;
  json primitive = primitive_of(document, {{"POSITION", document.add_positions(kSquare)}});
  primitive["indices"] =
      document.add_accessor(std::vector<std::uint8_t>{3, 1, 2, 1, 1, 2}, kUnsignedByte, "SCALAR", 6);
  document.add_mesh_node(primitive);
  const Scene scene = import(document);
  const Primitive& read = only_primitive(scene);
  EXPECT_EQ(read.triangles, std::vector<glm::uvec3>{glm::uvec3(0, 1, 2)})
      << "the second triangle is degenerate";
  ASSERT_EQ(read.positions.size(), 3U);
  EXPECT_EQ(read.positions[0], glm::vec3(0, 1, 0));
}

TEST_F(GltfGeometryTest, MendsNormalsWithoutDirection) {
  GltfDocument document = triangle_document();
  document.root["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
      document.add_positions({0, 0, 0, 0, 3, 4, 1, 0, 0});
  const Scene scene = import(document);
  EXPECT_EQ(only_primitive(scene).normals[0], glm::vec3(0, 0, 1));
  EXPECT_NEAR(only_primitive(scene).normals[1].z, 0.8, 1e-6);
}

TEST_F(GltfGeometryTest, SkipsPointsAndLinesWithANote) {
  GltfDocument document = triangle_document();
  document.root["meshes"][0]["primitives"].push_back(document.root["meshes"][0]["primitives"][0]);
  document.root["meshes"][0]["primitives"][0]["mode"] = 1;
  const Scene scene = import(document);
  EXPECT_EQ(scene.meshes[0].primitives.size(), 1U);
  EXPECT_TRUE(has_note(scene, "/meshes/0/primitives/0 skipped: points and lines"));
}

TEST_F(GltfGeometryTest, RefusesNumbersThatAreNotFinite) {
  GltfDocument document = triangle_document();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(document.bytes.data() + 12, &nan, 4);
  EXPECT_NE(refusal(document).find("/accessors/0: element 1 is not a finite number"), std::string::npos);
}

TEST_F(GltfGeometryTest, RefusesIndicesOfVerticesThatDoNotExist) {
  GltfDocument document = triangle_document();
  document.bytes[36 + 4] = 3;
  EXPECT_NE(refusal(document).find("/meshes/0/primitives/0/indices: index 2 is 3, but there are 3 vertices"),
            std::string::npos);
}

}  // namespace
}  // namespace vitrine
