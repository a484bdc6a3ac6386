// glTF files made in a test: a document under construction whose buffer is filled by typed arrays, and a
// scratch folder that it is written to and imported from.
#pragma once

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "scene/gltf_import.h"
#include "scene/input_error.h"

namespace vitrine {

using nlohmann::json;

inline constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
                     kUnsignedInt = 5125, kFloat = 5126;

/// 2x1 texels: red, then (0, 128, 255).
inline constexpr const char* kRedAndBluePng =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAEUlEQVR42mP4z8Dwn6Hh/38AEXkEfWTrTcwAAAAASUVORK5CYII=";

struct GltfDocument {
  json root = {{"asset", {{"version", "2.0"}}},
               {"buffers", json::array({{{"uri", "data.bin"}}})},
               {"bufferViews", json::array()},
               {"accessors", json::array()},
               {"meshes", json::array()},
               {"nodes", json::array()},
               {"scenes", json::array({{{"nodes", json::array()}}})}};
  std::vector<char> bytes;

  /// Appends values to the buffer (at a multiple of 4 bytes) and makes a view of them.
  template <class T>
  int add_view(const std::vector<T>& values) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    const std::size_t offset = bytes.size();
    bytes.resize(offset + values.size() * sizeof(T));
    std::memcpy(bytes.data() + offset, values.data(), values.size() * sizeof(T));
    root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size() * sizeof(T)}});
    return static_cast<int>(root["bufferViews"].size()) - 1;
  }

  int add_accessor(const json& accessor) {
    root["accessors"].push_back(accessor);
    return static_cast<int>(root["accessors"].size()) - 1;
  }

  template <class T>
  int add_accessor(const std::vector<T>& values, int component_type, const std::string& type,
                   std::size_t count) {
    return add_accessor({{"bufferView", add_view(values)},
                         {"componentType", component_type},
                         {"type", type},
                         {"count", count}});
  }

  int add_positions(const std::vector<float>& xyz) {
    return add_accessor(xyz, kFloat, "VEC3", xyz.size() / 3);
  }

  /// A node of the scene that shows a mesh of one primitive; returns the node's index.
  int add_mesh_node(const json& primitive) {
    root["meshes"].push_back({{"primitives", json::array({primitive})}});
    return add_root_node({{"mesh", root["meshes"].size() - 1}});
  }

  int add_root_node(const json& node) {
    root["nodes"].push_back(node);
    root["scenes"][0]["nodes"].push_back(root["nodes"].size() - 1);
    return static_cast<int>(root["nodes"].size()) - 1;
  }
};

/// One triangle (0,0,0) (1,0,0) (0,1,0) in mesh 0 on node 0, positions in accessor 0, indices 0 1 2 in
/// accessor 1.
inline GltfDocument triangle_document() {
  GltfDocument document;
  const int positions = document.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int indices = document.add_accessor(std::vector<std::uint16_t>{0, 1, 2}, kUnsignedShort, "SCALAR", 3);
  document.add_mesh_node({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  return document;
}

class GltfTest : public testing::Test {
 protected:
  GltfTest()
      : folder_(std::filesystem::temp_directory_path() /
                ("vitrine_gltf_" + std::to_string(getpid()) + "_" +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::create_directories(folder_);
  }
  ~GltfTest() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

  /// Writes test.gltf and, unless the document names other data, data.bin.
  void write(const GltfDocument& document) const {
    json root = document.root;
    if (root.contains("buffers") && !root["buffers"].empty() && root["buffers"][0].is_object() &&
        !root["buffers"][0].contains("byteLength")) {
      root["buffers"][0]["byteLength"] = std::max<std::size_t>(document.bytes.size(), 1);
    }
    write("data.bin", {document.bytes.begin(), document.bytes.end()});
    write("test.gltf", root.dump());
  }

  std::filesystem::path path(const std::string& name = "test.gltf") const { return folder_ / name; }

  Scene import(const GltfDocument& document) const {
    write(document);
    return import_gltf(path());
  }

  /// The message with which `name` is refused; empty and a failure if it is not.
  std::string refusal_of_file(const std::string& name) const {
    try {
      import_gltf(path(name));
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.rfind(path(name).string() + ": ", 0), 0U) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_NE(message.find("; "), std::string::npos) << "no remedy: " << message;
      return message.substr(path(name).string().size() + 2);
    }
    ADD_FAILURE() << name << " was not refused";
    return "";
  }

  std::string refusal(const GltfDocument& document) const {
    write(document);
    return refusal_of_file("test.gltf");
  }

  std::filesystem::path folder_;
};

inline bool has_note(const Scene& scene, const std::string& part) {
  for (const std::string& note : scene.notes) {
    if (note.find(part) != std::string::npos) return true;
  }
  return false;
}

/// The only primitive of the first mesh.
inline const Primitive& only_primitive(const Scene& scene) { return scene.meshes.at(0).primitives.at(0); }

}  // namespace vitrine
