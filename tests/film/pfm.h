// A colour PFM file, read back.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace vitrine {

struct Pfm {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;  ///< rows from top to bottom

  [[nodiscard]] const glm::vec3& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// Little-endian ones only. Throws std::runtime_error.
inline Pfm read_pfm(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string magic;
  double scale = 0.0;
  Pfm pfm;
  file >> magic >> pfm.width >> pfm.height >> scale;
  file.get();  // the one white space after the header
  if (!file || magic != "PF" || !(scale < 0.0))
    throw std::runtime_error(path.string() + ": not a little-endian PFM");
  pfm.pixels.resize(static_cast<std::size_t>(pfm.width) * static_cast<std::size_t>(pfm.height));
  const auto width = static_cast<std::size_t>(pfm.width);
  for (auto y = static_cast<std::size_t>(pfm.height); y-- > 0;) {
    file.read(reinterpret_cast<char*>(&pfm.pixels[y * width]),
              static_cast<std::streamsize>(width * sizeof(glm::vec3)));
  }
  if (!file || file.get() != std::ifstream::traits_type::eof()) {
    throw std::runtime_error(path.string() + ": too short or too long");
  }
  return pfm;
}

}  // namespace vitrine
