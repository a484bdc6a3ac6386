// Radiance files made in memory.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace vitrine {

inline std::string hdr_header(int width, int height, const std::string& variables = "") {
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + variables + "\n-Y " + std::to_string(height) + " +X " +
         std::to_string(width) + "\n";
}

inline std::string rgbe(int r, int g, int b, int e) {
  std::string pixel;
  for (const int byte : {r, g, b, e}) pixel += static_cast<char>(static_cast<unsigned char>(byte));
  return pixel;
}

/// The pixel nearest below `color`.
inline std::string rgbe(const glm::dvec3& color) {
  const double largest = std::max({color.r, color.g, color.b});
  if (!(largest > 0.0)) return rgbe(0, 0, 0, 0);
  int exponent = 0;
  (void)std::frexp(largest, &exponent);
  const auto mantissa = [&](double x) { return static_cast<int>(std::ldexp(x, 8 - exponent)); };
  return rgbe(mantissa(color.r), mantissa(color.g), mantissa(color.b), exponent + 128);
}

/// A file of raw pixels.
inline std::string hdr_file(int width, int height, const std::vector<glm::dvec3>& colors) {
  std::string file = hdr_header(width, height);
  for (const glm::dvec3& color : colors) file += rgbe(color);
  return file;
}

}  // namespace vitrine
