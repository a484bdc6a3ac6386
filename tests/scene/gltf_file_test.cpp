// Containers and files: .gltf with files or data URIs, .glb, and what may not be read.
#include <cstdint>

#include "scene/gltf_scratch.h"

namespace vitrine {
namespace {

using GltfFileTest = GltfTest;

std::string word(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
  return word(static_cast<std::uint32_t>(data.size())) + type + data;
}

std::string glb(const std::string& chunks) {
  return "glTF" + word(2) + word(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

std::string triangle_glb() {
  GltfDocument document = triangle_document();
  document.root["buffers"] = json::array({{{"byteLength", document.bytes.size()}}});
  std::string text = document.root.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  return glb(chunk("JSON", text) +
             chunk(std::string("BIN\0", 4), {document.bytes.begin(), document.bytes.end()}));
}

TEST_F(GltfFileTest, ReadsAFileWithABufferBesideIt) {
  const Scene scene = import(triangle_document());
  ASSERT_EQ(scene.instances.size(), 1U);
  EXPECT_EQ(only_primitive(scene).triangles.size(), 1U);
  EXPECT_EQ(scene.name, "test");
}

TEST_F(GltfFileTest, ReadsADataUri) {
  GltfDocument document = triangle_document();
  // Nine floats, three 16-bit indices.
  document.root["buffers"][0] = {
      {"byteLength", 42},
      {"uri",
       "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAA"
       "IA"}};
  EXPECT_EQ(only_primitive(import(document)).positions.at(1), glm::vec3(1, 0, 0));
}

TEST_F(GltfFileTest, ReadsGlbWhateverItsName) {
  write("scene.bin", triangle_glb());
  EXPECT_EQ(only_primitive(import_gltf(path("scene.bin"))).positions.at(2), glm::vec3(0, 1, 0));
}

TEST_F(GltfFileTest, RefusesEveryTruncationOfAGlb) {
  const std::string whole = triangle_glb();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    write("cut.glb", whole.substr(0, size));
    refusal_of_file("cut.glb");
  }
}

TEST_F(GltfFileTest, RefusesBrokenGlbChunks) {
  const std::string json_chunk = chunk("JSON", "{\"asset\":{\"version\":\"2.0\"}}  ");
  const std::string binary_chunk = chunk(std::string("BIN\0", 4), "1234");
  write("a.glb", glb(binary_chunk + json_chunk));
  EXPECT_NE(refusal_of_file("a.glb").find("GLB chunk 0"), std::string::npos);
  write("a.glb", glb(json_chunk + binary_chunk + binary_chunk));
  EXPECT_NE(refusal_of_file("a.glb").find("second BIN chunk"), std::string::npos);
  write("a.glb", "glTF" + word(1) + word(12));
  EXPECT_NE(refusal_of_file("a.glb").find("version 1 is not 2"), std::string::npos);
}

TEST_F(GltfFileTest, DecodesPercentSignsInFileNames) {
  GltfDocument document = triangle_document();
  document.root["buffers"][0]["uri"] = "my%20data.bin";
  write("my data.bin", {document.bytes.begin(), document.bytes.end()});
  EXPECT_EQ(import(document).instances.size(), 1U);
}

TEST_F(GltfFileTest, IgnoresWhatABufferFileHoldsBeyondItsByteLength) {
  GltfDocument document = triangle_document();
  document.root["buffers"][0]["byteLength"] = document.bytes.size();
  document.bytes.resize(document.bytes.size() + 100);
  EXPECT_EQ(import(document).instances.size(), 1U);
}

TEST_F(GltfFileTest, StaysInTheSceneFolder) {
  write("../vitrine_gltf_outside.bin", std::string(100, '\0'));
  for (const char* uri : {"../vitrine_gltf_outside.bin", "%2e%2e/vitrine_gltf_outside.bin", "/etc/passwd",
                          "x/../../vitrine_gltf_outside.bin"}) {
    GltfDocument document = triangle_document();
    document.root["buffers"][0]["uri"] = uri;
    const std::string message = refusal(document);
    EXPECT_EQ(message.rfind("/buffers/0/uri: ", 0), 0U) << message;
    EXPECT_NE(message.find("outside of the scene's folder"), std::string::npos) << message;
  }
  std::filesystem::remove(folder_ / "../vitrine_gltf_outside.bin");
}

TEST_F(GltfFileTest, RefusesBuffersThatCannotBeRead) {
  const std::pair<const char*, const char*> cases[] = {
      {"missing.bin", "does not exist"},
      {".", "is not a file"},
      {"", "no data"},
      {"http://example.org/data.bin", "is not a file name"},
      {"data:application/octet-stream;base64,AAAA", "there are only 3 bytes"},
      {"data:application/octet-stream;base64,AA*A", "base64 data is broken"},
      {"data:application/octet-stream;base64,", "base64 data is broken"},
      {"data:text/plain,hello", "not base64"}};
  for (const auto& [uri, problem] : cases) {
    GltfDocument document = triangle_document();
    document.root["buffers"][0]["uri"] = uri;
    const std::string message = refusal(document);
    EXPECT_EQ(message.rfind("/buffers/0", 0), 0U) << message;
    EXPECT_NE(message.find(problem), std::string::npos) << uri << ": " << message;
  }
}

TEST_F(GltfFileTest, RefusesTextThatIsNoGltf) {
  const std::pair<std::string, const char*> cases[] = {
      {"", "neither .glb nor well-formed JSON"},
      {"{\"asset\":", "neither .glb nor well-formed JSON"},
      {"\xFF\xFE", "neither .glb nor well-formed JSON"},
      {"[]", "not an object"},
      {"{}", "/asset/version"},
      {"{\"asset\":{\"version\":\"2.0\"},\"scene\":1e999}", "1e999"},
      {"{\"asset\":{\"version\":\"1.0\"}}", "/asset/version: \"1.0\" is not 2.0"},
      {"{\"asset\":{\"version\":\"2.0\"},\"extras\":" + std::string(50000, '[') + std::string(50000, ']') +
           "}",
       "nested deeper than 128 levels"},
      {"{\"asset\":{\"version\":\"2.0\"},\"extras\":[" + std::string(5'000'000, ','),
       "more than 4000000 values"}};
  for (const auto& [text, problem] : cases) {
    write("test.gltf", text);
    const std::string message = refusal_of_file("test.gltf");
    EXPECT_NE(message.find(problem), std::string::npos) << message;
  }
  EXPECT_NE(refusal_of_file("absent.gltf").find("does not exist"), std::string::npos);
  std::filesystem::create_directory(folder_ / "folder.gltf");
  EXPECT_NE(refusal_of_file("folder.gltf").find("not a file"), std::string::npos);
}

TEST_F(GltfFileTest, IgnoresBracketsInStringsAndAByteOrderMark) {
  GltfDocument document = triangle_document();
  document.root["extras"] = std::string(1000, '[') + "\"\\";
  write(document);
  std::ifstream stream(path(), std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  write("test.gltf", "\xEF\xBB\xBF" + text);
  EXPECT_EQ(import_gltf(path()).instances.size(), 1U);
}

}  // namespace
}  // namespace vitrine
