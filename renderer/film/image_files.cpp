#include "film/image_files.h"

#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <stb/stb_image_write.h>

namespace vitrine {
namespace {

void write_file(const std::filesystem::path& path, std::span<const char> bytes) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.flush();
  if (!file) {
    throw std::runtime_error(path.string() +
                             ": cannot be written: " + std::strerror(errno != 0 ? errno : EIO) +
                             "; name a file in a folder that exists and is writable");
  }
}

}  // namespace

void write_pfm(const std::filesystem::path& path, const Film& film) {
  write_pfm(path, film, film, film.width());
}

void write_pfm(const std::filesystem::path& path, const Film& left, const Film& right, int column) {
  static_assert(std::endian::native == std::endian::little, "PFM's scale below says little endian");
  const std::string header =
      "PF\n" + std::to_string(left.width()) + " " + std::to_string(left.height()) + "\n-1.0\n";
  std::vector<char> bytes(header.begin(), header.end());
  bytes.reserve(header.size() +
                static_cast<std::size_t>(left.width()) * static_cast<std::size_t>(left.height()) * 12);
  for (int y = left.height() - 1; y >= 0; --y) {
    for (int x = 0; x < left.width(); ++x) {
      const glm::vec3 nits((x < column ? left : right).mean_nits(x, y));
      const char* raw = reinterpret_cast<const char*>(&nits);
      bytes.insert(bytes.end(), raw, raw + sizeof nits);
    }
  }
  write_file(path, bytes);
}

void write_png(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgb) {
  std::vector<char> bytes;
  const auto append = [](void* context, void* data, int size) {
    const char* begin = static_cast<const char*>(data);
    static_cast<std::vector<char>*>(context)->insert(static_cast<std::vector<char>*>(context)->end(), begin,
                                                     begin + size);
  };
  if (stbi_write_png_to_func(append, &bytes, width, height, 3, rgb.data(), width * 3) == 0) {
    throw std::runtime_error(path.string() + ": the picture could not be encoded; free some memory");
  }
  write_file(path, bytes);
}

}  // namespace vitrine
