#include "scene/gltf_model.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "scene/gltf_extensions.h"
#include "scene/gltf_limits.h"
#include "scene/gltf_schema.h"

namespace vitrine {
namespace {

using nlohmann::json;

// tinygltf asks for a buffer under the name that set_aside_uris gives it, "buffers/N".
constexpr const char* kBufferName = "buffers/";

struct BufferSource {
  const GltfFile& file;
  std::vector<std::string> uris;
  std::vector<std::size_t> lengths;
  std::vector<unsigned char> binary_chunk;
};

std::vector<unsigned char> read_buffer(BufferSource& source, std::size_t index) {
  const std::string place = "/buffers/" + std::to_string(index);
  const bool embedded = index == 0 && source.uris[0].empty() && !source.binary_chunk.empty();
  if (!embedded && source.uris[index].empty()) {
    source.file.refuse(place, "the buffer has no data, neither a uri nor a BIN chunk", "give it its data");
  }
  auto bytes =
      embedded ? std::move(source.binary_chunk) : source.file.read_uri(source.uris[index], place + "/uri");
  if (bytes.size() < source.lengths[index]) {
    source.file.refuse(place + "/byteLength",
                       "is " + std::to_string(source.lengths[index]) + ", but there are only " +
                           std::to_string(bytes.size()) + " bytes",
                       "the data may be cut short: export the file again");
  }
  bytes.resize(source.lengths[index]);
  return bytes;
}

bool is_buffer(const std::string& name, void* /*source*/) { return name.compare(0, 8, kBufferName) == 0; }

std::string same_name(const std::string& name, void* /*source*/) { return name; }

bool read_named_buffer(std::vector<unsigned char>* bytes, std::string* /*error*/, const std::string& name,
                       void* source) {
  *bytes = read_buffer(*static_cast<BufferSource*>(source), std::stoul(name.substr(8)));
  return true;
}

bool refuse_to_write(std::string* /*error*/, const std::string& /*name*/,
                     const std::vector<unsigned char>& /*bytes*/, void* /*source*/) {
  return false;
}

bool leave_image_encoded(tinygltf::Image* /*image*/, int /*index*/, std::string* /*error*/,
                         std::string* /*warning*/, int /*width*/, int /*height*/,
                         const unsigned char* /*bytes*/, int /*size*/, void* /*data*/) {
  return true;
}

// Takes the uris of `collection` out of the document, long data URIs among them, and puts names in their
// place.
std::vector<std::string> set_aside_uris(json& document, const std::string& collection) {
  std::vector<std::string> uris;
  if (!document.contains(collection)) return uris;
  for (json& object : document[collection]) {
    uris.push_back(object.value("uri", ""));
    const bool in_view = object.contains("bufferView");
    if (!in_view) object["uri"] = collection + "/" + std::to_string(uris.size() - 1);
  }
  return uris;
}

// An array of the root, empty where the document has none.
const json& elements_of(const json& document, const char* collection) {
  static const json kNone = json::array();
  const auto found = document.find(collection);
  return found == document.end() ? kNone : *found;
}

void check_buffer_views(const GltfFile& file, const json& document) {
  std::size_t total = 0;
  const json& buffers = elements_of(document, "buffers");
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    total += buffers[i]["byteLength"].get<std::size_t>();
    if (total > gltf_limits::kMaxBufferBytes) {
      file.refuse("/buffers/" + std::to_string(i) + "/byteLength",
                  "the buffers hold more than " + std::to_string(gltf_limits::kMaxBufferBytes >> 20) + " MiB",
                  "split the scene");
    }
  }
  const json& views = elements_of(document, "bufferViews");
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::size_t end =
        views[i].value("byteOffset", std::size_t{0}) + views[i]["byteLength"].get<std::size_t>();
    const std::size_t size = buffers[views[i]["buffer"].get<std::size_t>()]["byteLength"].get<std::size_t>();
    if (end > size) {
      file.refuse(
          "/bufferViews/" + std::to_string(i),
          "ends at byte " + std::to_string(end) + " of a buffer of " + std::to_string(size) + " bytes",
          "correct its byteOffset or byteLength, or export the file again");
    }
  }
}

void check_image_sources(const GltfFile& file, const json& document) {
  const json& images = elements_of(document, "images");
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (images[i].contains("uri") == images[i].contains("bufferView")) {
      file.refuse("/images/" + std::to_string(i), "an image has a uri or a bufferView, one of them",
                  "export the file again");
    }
  }
}

// Cameras and spot lights are described by the member that their type names.
void check_typed_objects(const GltfFile& file, const json& array, const std::string& place,
                         const std::vector<std::string>& types_with_member) {
  for (std::size_t i = 0; i < array.size(); ++i) {
    for (const std::string& type : types_with_member) {
      if (array[i]["type"] == type && !array[i].contains(type)) {
        file.refuse(place + "/" + std::to_string(i),
                    "the type is " + type + ", but \"" + type + "\" is missing", "export the file again");
      }
    }
  }
}

tinygltf::Model parse_with_tinygltf(const json& document, BufferSource& source) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.FileExists = is_buffer;
  callbacks.ExpandFilePath = same_name;
  callbacks.ReadWholeFile = read_named_buffer;
  callbacks.WriteWholeFile = refuse_to_write;
  callbacks.user_data = &source;

  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(callbacks);
  loader.SetImageLoader(leave_image_encoded, nullptr);
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const std::string text = document.dump();
  bool loaded = false;
  try {
    loaded = loader.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                        static_cast<unsigned int>(text.size()), "", tinygltf::NO_REQUIRE);
  } catch (const std::logic_error& thrown) {
    error = thrown.what();
  }
  if (!loaded) source.file.refuse("", error.empty() ? "it cannot be parsed" : error, "export the file again");
  return model;
}

}  // namespace

void GltfModel::note(const std::string& text) {
  if (std::find(notes.begin(), notes.end(), text) == notes.end()) notes.push_back(text);
}

GltfModel load_gltf_model(const std::filesystem::path& path) {
  GltfModel result{GltfFile(path), {}, {}, {}};
  GltfFile::Contents contents = result.file.read();
  json document = result.file.parse(contents.json_text);
  contents.json_text.clear();
  check_gltf_extensions(result.file, document, result.notes);
  check_gltf_schema(result.file, document);
  check_buffer_views(result.file, document);
  check_image_sources(result.file, document);
  check_typed_objects(result.file, elements_of(document, "cameras"), "/cameras",
                      {"perspective", "orthographic"});
  const json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
  if (document.contains(lights))
    check_typed_objects(result.file, document[lights], lights.to_string(), {"spot"});

  for (const char* key : {"animations", "skins"}) {
    if (document.contains(key))
      result.note(std::string(key) + " ignored: everything is shown in its bind pose");
    document.erase(key);
  }
  BufferSource source{result.file, set_aside_uris(document, "buffers"), {}, std::move(contents.binary_chunk)};
  for (const json& buffer : elements_of(document, "buffers")) {
    source.lengths.push_back(buffer["byteLength"].get<std::size_t>());
  }
  result.image_uris = set_aside_uris(document, "images");
  result.model = parse_with_tinygltf(document, source);
  return result;
}

}  // namespace vitrine
