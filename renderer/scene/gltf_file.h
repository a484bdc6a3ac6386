// The bytes of a glTF file before anybody interprets them: the .glb container taken apart, the JSON text held
// against the limits and parsed, and the files and data URIs that it refers to, read from the folder of the
// scene and from nowhere else.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace vitrine {

/// Names a glTF file in messages and reads what it refers to.
class GltfFile {
 public:
  explicit GltfFile(std::filesystem::path path) : path_(std::move(path)) {}

  [[nodiscard]] std::string path() const { return path_.string(); }

  struct Contents {
    std::string json_text;
    std::vector<unsigned char> binary_chunk;  ///< of a .glb; empty: none
  };
  /// Reads the file and takes a .glb apart (recognised by its first bytes, not by its name).
  Contents read() const;

  /// Parses a text whose nesting and size are within the limits. The result is an object.
  nlohmann::json parse(const std::string& json_text) const;

  /// The bytes behind a `uri` of the JSON: a base64 data URI, or a regular file in or below the scene's
  /// folder.
  std::vector<unsigned char> read_uri(const std::string& uri, const std::string& place) const;

  /// Throws InputError. `place` is a JSON pointer such as /accessors/3/bufferView, or empty for the whole
  /// file.
  [[noreturn]] void refuse(const std::string& place, const std::string& problem,
                           const std::string& remedy) const;

  std::string stem() const { return path_.stem().string(); }

 private:
  std::vector<unsigned char> read_bytes(const std::filesystem::path& path, const std::string& place) const;
  Contents take_glb_apart(const std::vector<unsigned char>& bytes) const;
  std::vector<unsigned char> decode_data_uri(const std::string& uri, const std::string& place) const;
  std::filesystem::path confined(const std::string& uri, const std::string& place) const;

  std::filesystem::path path_;
};

/// The text with control characters replaced and cut to a length that fits a message of one line.
std::string one_line(const std::string& text);

}  // namespace vitrine
