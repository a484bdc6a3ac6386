// Pixels of any format: writing rows, reading back, and filling rectangles. All drawing is clipped to the
// surface, and no byte between the rows is touched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "display.h"

namespace vitrine {

/// A display-referred sRGB colour.
struct Rgb8 {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  bool operator==(const Rgb8&) const = default;
};

/// The pixels [x, x + width) x [y, y + height), y downwards.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  [[nodiscard]] bool contains(int px, int py) const {
    return px >= x && px < x + width && py >= y && py < y + height;
  }
  bool operator==(const PixelRect&) const = default;
};

[[nodiscard]] int bytes_per_pixel(PixelFormat format);

/// Writes a row of R, G, B bytes to (x, y) and the pixels right of it.
void write_rgb_row(const Surface& surface, int x, int y, std::span<const std::uint8_t> rgb);

/// The pixel at (x, y), which must lie on the surface.
[[nodiscard]] Rgb8 read_pixel(const Surface& surface, int x, int y);

/// Lays `colour` over the pixel at (x, y) with `coverage` / 255 of it.
void blend_pixel(const Surface& surface, int x, int y, Rgb8 colour, int coverage);

void fill_rect(const Surface& surface, const PixelRect& rect, Rgb8 colour, int coverage = 255);

/// A rectangle whose corners are quarter circles of `radius` pixels, anti-aliased.
void fill_rounded_rect(const Surface& surface, const PixelRect& rect, int radius, Rgb8 colour);

/// Memory for a surface. Its rows are padded, as those of real screens are.
class SurfaceMemory {
 public:
  /// Black. Throws std::runtime_error unless 1 <= width, height <= 16384.
  SurfaceMemory(int width, int height, PixelFormat format);
  SurfaceMemory(SurfaceMemory&&) = default;  // moved bytes stay where they are; copied ones would not
  SurfaceMemory& operator=(SurfaceMemory&&) = default;

  [[nodiscard]] const Surface& surface() const { return surface_; }

 private:
  std::vector<std::byte> bytes_;
  Surface surface_;
};

}  // namespace vitrine
