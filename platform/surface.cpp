#include "surface.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

namespace vitrine {
namespace {

// One struct a format: how a colour lies in memory.
struct Xrgb8888 {
  static constexpr int kBytes = 4;
  static void store(std::byte* at, Rgb8 c) {
    const std::uint32_t word = std::uint32_t{c.r} << 16 | std::uint32_t{c.g} << 8 | std::uint32_t{c.b};
    std::memcpy(at, &word, sizeof word);
  }
  static Rgb8 load(const std::byte* at) {
    std::uint32_t word = 0;
    std::memcpy(&word, at, sizeof word);
    return {static_cast<std::uint8_t>(word >> 16), static_cast<std::uint8_t>(word >> 8),
            static_cast<std::uint8_t>(word)};
  }
};

struct Rgb888 {
  static constexpr int kBytes = 3;
  static void store(std::byte* at, Rgb8 c) {
    at[0] = std::byte{c.r};
    at[1] = std::byte{c.g};
    at[2] = std::byte{c.b};
  }
  static Rgb8 load(const std::byte* at) {
    return {std::to_integer<std::uint8_t>(at[0]), std::to_integer<std::uint8_t>(at[1]),
            std::to_integer<std::uint8_t>(at[2])};
  }
};

struct Rgb565 {
  static constexpr int kBytes = 2;
  static unsigned nearest(unsigned value, unsigned max) { return (value * max + 127) / 255; }
  static std::uint8_t widened(unsigned value, unsigned max) {
    return static_cast<std::uint8_t>((value * 255 + max / 2) / max);
  }
  static void store(std::byte* at, Rgb8 c) {
    const auto word =
        static_cast<std::uint16_t>(nearest(c.r, 31) << 11 | nearest(c.g, 63) << 5 | nearest(c.b, 31));
    std::memcpy(at, &word, sizeof word);
  }
  static Rgb8 load(const std::byte* at) {
    std::uint16_t word = 0;
    std::memcpy(&word, at, sizeof word);
    return {widened(word >> 11U, 31), widened(word >> 5U & 63U, 63), widened(word & 31U, 31)};
  }
};

/// Calls `draw` with the struct of the format.
template <class Draw>
auto with_format(PixelFormat format, Draw&& draw) {
  switch (format) {
    case PixelFormat::kRgb888:
      return draw(Rgb888{});
    case PixelFormat::kRgb565:
      return draw(Rgb565{});
    case PixelFormat::kXrgb8888:
      break;
  }
  return draw(Xrgb8888{});
}

std::byte* pixel_at(const Surface& surface, int x, int y, int bytes) {
  return surface.pixels + static_cast<std::size_t>(y) * surface.stride_bytes +
         static_cast<std::size_t>(x) * static_cast<std::size_t>(bytes);
}

std::uint8_t mixed(int below, int above, int coverage) {
  return static_cast<std::uint8_t>((below * (255 - coverage) + above * coverage + 127) / 255);
}

Rgb8 mixed(Rgb8 below, Rgb8 above, int coverage) {
  return {mixed(below.r, above.r, coverage), mixed(below.g, above.g, coverage),
          mixed(below.b, above.b, coverage)};
}

/// How much of a pixel, 0..255, lies within `radius` of a corner's centre that is (dx, dy) pixels away.
int corner_coverage(double dx, double dy, double radius) {
  const double inside = radius - std::hypot(dx, dy) + 0.5;
  return static_cast<int>(std::lround(255.0 * std::clamp(inside, 0.0, 1.0)));
}

}  // namespace

int bytes_per_pixel(PixelFormat format) {
  return with_format(format, [](auto pixel) { return pixel.kBytes; });
}

void write_rgb_row(const Surface& surface, int x, int y, std::span<const std::uint8_t> rgb) {
  if (y < 0 || y >= surface.height) return;
  const int begin = std::max(x, 0);
  const int end = static_cast<int>(
      std::min<std::int64_t>(surface.width, std::int64_t{x} + static_cast<std::int64_t>(rgb.size() / 3)));
  if (begin >= end) return;
  with_format(surface.format, [&](auto pixel) {
    const std::uint8_t* from = rgb.data() + 3 * (static_cast<std::ptrdiff_t>(begin) - x);
    std::byte* to = pixel_at(surface, begin, y, pixel.kBytes);
    for (int i = begin; i < end; ++i, from += 3, to += pixel.kBytes) {
      pixel.store(to, {from[0], from[1], from[2]});
    }
  });
}

Rgb8 read_pixel(const Surface& surface, int x, int y) {
  return with_format(surface.format,
                     [&](auto pixel) { return pixel.load(pixel_at(surface, x, y, pixel.kBytes)); });
}

void blend_pixel(const Surface& surface, int x, int y, Rgb8 colour, int coverage) {
  fill_rect(surface, {x, y, 1, 1}, colour, coverage);
}

void fill_rect(const Surface& surface, const PixelRect& rect, Rgb8 colour, int coverage) {
  const int x0 = std::max(rect.x, 0);
  const int x1 = std::min(rect.x + rect.width, surface.width);
  const int y0 = std::max(rect.y, 0);
  const int y1 = std::min(rect.y + rect.height, surface.height);
  if (coverage <= 0 || x0 >= x1) return;
  with_format(surface.format, [&](auto pixel) {
    for (int y = y0; y < y1; ++y) {
      std::byte* at = pixel_at(surface, x0, y, pixel.kBytes);
      for (int x = x0; x < x1; ++x, at += pixel.kBytes) {
        pixel.store(at, coverage >= 255 ? colour : mixed(pixel.load(at), colour, coverage));
      }
    }
  });
}

void fill_rounded_rect(const Surface& surface, const PixelRect& rect, int radius, Rgb8 colour) {
  if (rect.width <= 0 || rect.height <= 0) return;
  const int r = std::clamp(radius, 0, std::min(rect.width, rect.height) / 2);
  fill_rect(surface, {rect.x, rect.y + r, rect.width, rect.height - 2 * r}, colour);
  for (int j = 0; j < r; ++j) {
    const int top = rect.y + j;
    const int bottom = rect.y + rect.height - 1 - j;
    for (const int y : {top, bottom}) {
      fill_rect(surface, {rect.x + r, y, rect.width - 2 * r, 1}, colour);
      for (int i = 0; i < r; ++i) {
        const int coverage = corner_coverage(r - i - 0.5, r - j - 0.5, r);
        blend_pixel(surface, rect.x + i, y, colour, coverage);
        blend_pixel(surface, rect.x + rect.width - 1 - i, y, colour, coverage);
      }
    }
  }
}

SurfaceMemory::SurfaceMemory(int width, int height, PixelFormat format) {
  constexpr int kMaxSide = 16384;
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide) {
    throw std::runtime_error("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                             " pixels is impossible; choose 1x1 to 16384x16384");
  }
  constexpr std::size_t kPadding = 64;
  const std::size_t row = static_cast<std::size_t>(width) * static_cast<std::size_t>(bytes_per_pixel(format));
  const std::size_t stride = (row + kPadding) / 16 * 16 + 16;
  bytes_.resize(stride * static_cast<std::size_t>(height));
  surface_ = {bytes_.data(), width, height, stride, format};
}

}  // namespace vitrine
