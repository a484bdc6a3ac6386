#include "scene/gltf_file.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>

#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include "scene/gltf_limits.h"
#include "scene/input_error.h"

namespace vitrine {
namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67;   // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr const char* kExportAgain = "export the file again";

std::uint32_t little_endian_u32(const unsigned char* bytes) {
  return std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
         std::uint32_t{bytes[3]} << 24;
}

bool is_data_uri(const std::string& uri) { return uri.compare(0, 5, "data:") == 0; }

// RFC 3986: a scheme is a letter, then letters, digits, '+', '-', '.', up to a colon that precedes every '/'.
bool has_scheme(const std::string& uri) {
  const auto end = uri.find_first_of(":/?#");
  return end != std::string::npos && uri[end] == ':';
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percent_decoded(const std::string& uri) {
  std::string decoded;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? hex_digit(uri[i + 1]) : -1;
    const int low = high >= 0 ? hex_digit(uri[i + 2]) : -1;
    if (low < 0) {
      decoded += uri[i];
    } else {
      decoded += static_cast<char>(high * 16 + low);
      i += 2;
    }
  }
  return decoded;
}

std::string mebibytes(std::size_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

}  // namespace

std::string one_line(const std::string& text) {
  constexpr std::size_t kMaxLength = 200;
  std::string line = text.substr(0, kMaxLength);
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
  return text.size() > kMaxLength ? line + "..." : line;
}

void GltfFile::refuse(const std::string& place, const std::string& problem, const std::string& remedy) const {
  throw InputError(path_.string(), one_line(place), one_line(problem), remedy);
}

std::vector<unsigned char> GltfFile::read_bytes(const std::filesystem::path& path,
                                                const std::string& place) const {
  const std::string name = place.empty() ? "the file" : "\"" + path.string() + "\"";
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    refuse(place, name + " does not exist", "put the file there or correct the name");
  if (!std::filesystem::is_regular_file(status)) refuse(place, name + " is not a file", "name a file");
  const auto size = std::filesystem::file_size(path, error);
  if (error || size > gltf_limits::kMaxFileBytes) {
    refuse(place, name + " is larger than " + mebibytes(gltf_limits::kMaxFileBytes), "make it smaller");
  }
  std::vector<unsigned char> bytes(static_cast<std::size_t>(size));
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!stream) refuse(place, name + " cannot be read", "check the permissions of the file");
  return bytes;
}

GltfFile::Contents GltfFile::read() const {
  const auto bytes = read_bytes(path_, "");
  if (bytes.size() >= 4 && little_endian_u32(bytes.data()) == kGlbMagic) return take_glb_apart(bytes);
  return {std::string(bytes.begin(), bytes.end()), {}};
}

// Header: magic, version, length. Then chunks of length, type and data: JSON first, at most one BIN, others
// ignored.
GltfFile::Contents GltfFile::take_glb_apart(const std::vector<unsigned char>& bytes) const {
  constexpr std::size_t kHeaderBytes = 12;
  constexpr std::size_t kChunkHeaderBytes = 8;
  const auto word = [&](std::size_t offset) { return little_endian_u32(bytes.data() + offset); };

  if (bytes.size() < kHeaderBytes) refuse("GLB header", "the file ends in it", kExportAgain);
  if (word(4) != 2)
    refuse("GLB header", "version " + std::to_string(word(4)) + " is not 2", "export it as glTF 2.0");
  const std::size_t end = word(8);
  if (end < kHeaderBytes || end > bytes.size()) {
    refuse("GLB header",
           "says " + std::to_string(end) + " bytes, but the file has " + std::to_string(bytes.size()),
           kExportAgain);
  }

  Contents contents;
  bool binary_seen = false;
  int chunk = 0;
  for (std::size_t at = kHeaderBytes; at < end; ++chunk) {
    const std::string place = "GLB chunk " + std::to_string(chunk);
    if (end - at < kChunkHeaderBytes) refuse(place, "the file ends in its header", kExportAgain);
    const std::size_t length = word(at);
    const std::uint32_t type = word(at + 4);
    at += kChunkHeaderBytes;
    if (length > end - at) {
      refuse(place,
             "says " + std::to_string(length) + " bytes, but " + std::to_string(end - at) + " are left",
             kExportAgain);
    }
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const auto last = first + static_cast<std::ptrdiff_t>(length);
    if ((chunk == 0) != (type == kJsonChunk))
      refuse(place, "the first chunk, and only it, must be JSON", kExportAgain);
    if (type == kJsonChunk) {
      contents.json_text.assign(first, last);
    } else if (type == kBinaryChunk) {
      if (binary_seen) refuse(place, "a second BIN chunk", kExportAgain);
      binary_seen = true;
      contents.binary_chunk.assign(first, last);
    }
    at += length;
  }
  if (chunk == 0) refuse("GLB header", "no JSON chunk follows", kExportAgain);
  return contents;
}

nlohmann::json GltfFile::parse(const std::string& json_text) const {
  std::size_t depth = 0;
  std::size_t values = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json_text.size(); ++i) {
    const char c = json_text[i];
    if (in_string) {
      if (c == '\\') ++i;
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      ++values;
      if (++depth > gltf_limits::kMaxJsonDepth) {
        refuse("byte " + std::to_string(i),
               "the JSON is nested deeper than " + std::to_string(gltf_limits::kMaxJsonDepth) + " levels",
               "flatten its extras or export it again");
      }
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    } else if (c == ',') {
      ++values;
    }
  }
  if (values > gltf_limits::kMaxJsonValues) {
    refuse("", "the JSON holds more than " + std::to_string(gltf_limits::kMaxJsonValues) + " values",
           "keep bulk data in buffers");
  }

  nlohmann::json document;
  try {
    document = nlohmann::json::parse(json_text);
  } catch (const nlohmann::json::parse_error& error) {
    refuse("byte " + std::to_string(error.byte), "it is neither .glb nor well-formed JSON", kExportAgain);
  } catch (const nlohmann::json::out_of_range& error) {
    const std::string what = error.what();  // "... number overflow parsing '1e999'"
    refuse("", "the JSON number " + what.substr(what.rfind(' ') + 1) + " is too large", "correct the number");
  }
  if (!document.is_object()) refuse("", "the JSON is not an object", kExportAgain);
  return document;
}

std::vector<unsigned char> GltfFile::read_uri(const std::string& uri, const std::string& place) const {
  return is_data_uri(uri) ? decode_data_uri(uri, place) : read_bytes(confined(uri, place), place);
}

std::vector<unsigned char> GltfFile::decode_data_uri(const std::string& uri, const std::string& place) const {
  const auto comma = uri.find(',');
  constexpr std::string_view kBase64 = ";base64";
  if (comma == std::string::npos || comma < kBase64.size() ||
      uri.compare(comma - kBase64.size(), kBase64.size(), kBase64) != 0) {
    refuse(place, "the data URI is not base64", "store the data as data:application/octet-stream;base64,...");
  }
  std::string payload = uri.substr(comma + 1);
  const auto last = payload.find_last_not_of('=');
  const std::size_t digits = last == std::string::npos ? 0 : last + 1;

  // tinygltf decodes only under a few MIME types; what the data is, is known from its use.
  std::vector<unsigned char> bytes;
  std::string mime_type;
  if (digits > 0) {
    tinygltf::DecodeDataURI(&bytes, mime_type, "data:application/octet-stream;base64," + std::move(payload),
                            0, false);
  }
  // The decoder stops silently at the first character that is no digit.
  if (bytes.empty() || bytes.size() != digits * 3 / 4)
    refuse(place, "the base64 data is broken", kExportAgain);
  return bytes;
}

std::filesystem::path GltfFile::confined(const std::string& uri, const std::string& place) const {
  if (has_scheme(uri)) {
    refuse(place, "\"" + uri + "\" is not a file name", "put the file beside the scene and name it there");
  }
  const std::string decoded = percent_decoded(uri);
  const std::filesystem::path relative(decoded);
  const bool leaves =
      relative.is_absolute() || std::find(relative.begin(), relative.end(), "..") != relative.end();
  if (leaves || decoded.find('\0') != std::string::npos) {
    refuse(place, "\"" + decoded + "\" lies outside of the scene's folder", "put the file beside the scene");
  }
  if (decoded.empty()) refuse(place, "the uri is empty", "name a file");
  return path_.parent_path() / relative;
}

}  // namespace vitrine
