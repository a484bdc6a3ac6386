// The way to the screen, held against an oracle that takes one pixel at a time from the definitions: for
// every rotation, scaling, layout and many odd sizes and strides; and no byte is written that is not the
// picture's.
#include "scan_out.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace vitrine {
namespace {

struct NamedLayout {
  const char* name;
  PixelLayout layout;
};

const NamedLayout kLayouts[] = {
    {"XRGB8888", {32, {16, 8}, {8, 8}, {0, 8}, 0}},
    {"ARGB8888", {32, {16, 8}, {8, 8}, {0, 8}, 0xff000000}},
    {"XBGR8888", {32, {0, 8}, {8, 8}, {16, 8}, 0}},
    {"RGBX8888", {32, {24, 8}, {16, 8}, {8, 8}, 0xff}},
    {"RGB888", {24, {16, 8}, {8, 8}, {0, 8}, 0}},
    {"BGR888", {24, {0, 8}, {8, 8}, {16, 8}, 0}},
    {"RGB565", {16, {11, 5}, {5, 6}, {0, 5}, 0}},
    {"BGR565", {16, {0, 5}, {5, 6}, {11, 5}, 0}},
    {"ARGB1555", {16, {10, 5}, {5, 5}, {0, 5}, 0x8000}},
    {"XRGB4444", {16, {8, 4}, {4, 4}, {0, 4}, 0}},
    {"RGB666 in 24", {24, {12, 6}, {6, 6}, {0, 6}, 0}},
    {"XRGB2101010", {32, {20, 10}, {10, 10}, {0, 10}, 0}},
    {"one bit a colour", {16, {3, 1}, {9, 1}, {14, 1}, 0}},
    {"8, 7 and 2 bits", {32, {1, 8}, {14, 7}, {29, 2}, 0x80000000}},
};

SurfaceMemory noise(int width, int height) {
  SurfaceMemory memory(width, height, PixelFormat::kXrgb8888);
  std::mt19937 random(static_cast<unsigned>(width * 1000 + height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint32_t word = static_cast<std::uint32_t>(random()) & 0xffffff;
      std::memcpy(memory.surface().pixels + static_cast<std::size_t>(y) * memory.surface().stride_bytes +
                      static_cast<std::size_t>(x) * 4,
                  &word, sizeof word);
    }
  }
  return memory;
}

/// The classic 8 x 8 matrix by its recursion, M(2n) = [4M, 4M + 2; 4M + 3, 4M + 1].
int bayer(int x, int y, int size = 8) {
  if (size == 1) return 0;
  const int half = size / 2;
  const int corner[2][2] = {{0, 2}, {3, 1}};
  return 4 * bayer(x % half, y % half, half) + corner[y / half][x / half];
}

/// A colour's bits on the screen at (x, y), from the definition.
std::uint32_t level(int value, int bits, bool dithered, int x, int y) {
  const int most = (1 << bits) - 1;
  if (!dithered) return static_cast<std::uint32_t>(std::lround(value * static_cast<double>(most) / 255.0));
  return static_cast<std::uint32_t>((value * most + (bayer(x % 8, y % 8) * 255 + 127) / 64) / 255);
}

std::uint32_t encoded(const PixelLayout& layout, Rgb8 colour, int x, int y) {
  const bool dithered = layout.red.length <= 8 && layout.green.length <= 8 && layout.blue.length <= 8;
  return level(colour.r, layout.red.length, dithered, x, y) << layout.red.offset |
         level(colour.g, layout.green.length, dithered, x, y) << layout.green.offset |
         level(colour.b, layout.blue.length, dithered, x, y) << layout.blue.offset | layout.always_set;
}

/// The pixel of the picture that a point of the turned picture, in 0..1, shows.
Rgb8 picked(const Surface& picture, double u, double v, int rotation) {
  const double turned_u = rotation == 0 ? u : rotation == 90 ? v : rotation == 180 ? 1 - u : 1 - v;
  const double turned_v = rotation == 0 ? v : rotation == 90 ? 1 - u : rotation == 180 ? 1 - v : u;
  return read_pixel(picture, static_cast<int>(turned_u * picture.width),
                    static_cast<int>(turned_v * picture.height));
}

std::uint32_t word_at(const std::vector<std::byte>& bytes, std::size_t at, int count) {
  std::uint32_t word = 0;
  for (int i = 0; i < count; ++i) {
    word |= std::to_integer<std::uint32_t>(bytes[at + static_cast<std::size_t>(i)]) << (8 * i);
  }
  return word;
}

struct Case {
  Extent picture;
  Extent screen;
};

// Sides are odd where the picture is scaled: then no pixel's middle falls between two pixels of the picture.
const Case kCases[] = {
    {{15, 9}, {15, 9}},   {{13, 7}, {13, 7}},  {{13, 7}, {7, 13}},   {{5, 3}, {31, 29}},
    {{33, 19}, {17, 51}}, {{1, 1}, {9, 4}},    {{3, 51}, {50, 40}},  {{41, 35}, {11, 9}},
    {{17, 33}, {67, 45}}, {{63, 1}, {65, 33}}, {{48, 48}, {48, 48}},
};

class ScanOutTest : public testing::TestWithParam<int> {};

TEST_P(ScanOutTest, EveryByteIsAsTheDefinitionSays) {
  const int rotation = GetParam();
  constexpr std::byte kUntouched{0xa5};
  for (const NamedLayout& named : kLayouts) {
    const int bytes = named.layout.bits_per_pixel / 8;
    for (const Case& size : kCases) {
      for (const Scaling scaling : {Scaling::kFitted, Scaling::kInteger}) {
        for (const int padding : {0, 1, 13}) {
          SCOPED_TRACE(std::string(named.name) + " " + std::to_string(size.picture.width) + "x" +
                       std::to_string(size.picture.height) + " on " + std::to_string(size.screen.width) +
                       "x" + std::to_string(size.screen.height) + " rotated " + std::to_string(rotation));
          const SurfaceMemory picture = noise(size.picture.width, size.picture.height);
          const ScreenMemory screen{size.screen.width, size.screen.height,
                                    static_cast<std::size_t>(size.screen.width * bytes + padding),
                                    named.layout};
          std::vector<std::byte> pixels(screen.stride_bytes * static_cast<std::size_t>(screen.height),
                                        kUntouched);
          ScanOut scan_out(size.picture, screen, rotation, scaling);
          scan_out.copy(picture.surface(), pixels.data());

          const PixelRect rect =
              place_picture(turned(size.picture, rotation), {screen.width, screen.height}, scaling);
          ASSERT_EQ(scan_out.rect(), rect);
          for (int y = 0; y < screen.height; ++y) {
            const std::size_t row = static_cast<std::size_t>(y) * screen.stride_bytes;
            for (int x = 0; x < screen.width; ++x) {
              const std::size_t at = row + static_cast<std::size_t>(x * bytes);
              if (!rect.contains(x, y)) {
                for (int i = 0; i < bytes; ++i)
                  ASSERT_EQ(pixels[at + static_cast<std::size_t>(i)], kUntouched);
                continue;
              }
              const Rgb8 colour = picked(picture.surface(), (x - rect.x + 0.5) / rect.width,
                                         (y - rect.y + 0.5) / rect.height, rotation);
              ASSERT_EQ(word_at(pixels, at, bytes), encoded(named.layout, colour, x, y)) << x << "," << y;
            }
            for (std::size_t i = static_cast<std::size_t>(screen.width * bytes); i < screen.stride_bytes;
                 ++i) {
              ASSERT_EQ(pixels[row + i], kUntouched) << "between the rows";
            }
          }

          scan_out.blacken(pixels.data());
          for (int y = 0; y < screen.height; ++y) {
            const std::size_t row = static_cast<std::size_t>(y) * screen.stride_bytes;
            for (int x = 0; x < screen.width; ++x) {
              ASSERT_EQ(word_at(pixels, row + static_cast<std::size_t>(x * bytes), bytes),
                        named.layout.always_set);
            }
            for (std::size_t i = static_cast<std::size_t>(screen.width * bytes); i < screen.stride_bytes;
                 ++i) {
              ASSERT_EQ(pixels[row + i], kUntouched) << "between the rows";
            }
          }
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rotations, ScanOutTest, testing::Values(0, 90, 180, 270),
                         [](const auto& rotation) { return "By" + std::to_string(rotation.param); });

TEST(ScanOut, ATurnIsClockwise) {
  const SurfaceMemory picture(3, 2, PixelFormat::kXrgb8888);
  fill_rect(picture.surface(), {0, 0, 1, 1}, {255, 0, 0});  // the upper left corner
  const Extent corners[] = {{0, 0}, {1, 0}, {2, 1}, {0, 2}};
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Extent seen = turned({3, 2}, quarter * 90);
    const SurfaceMemory screen(seen.width, seen.height, PixelFormat::kXrgb8888);
    ScanOut({3, 2}, {seen.width, seen.height, screen.surface().stride_bytes, {}}, quarter * 90,
            Scaling::kFitted)
        .copy(picture.surface(), screen.surface().pixels);
    const Extent corner = corners[quarter];
    EXPECT_EQ(read_pixel(screen.surface(), corner.width, corner.height), (Rgb8{255, 0, 0})) << quarter;
  }
}

TEST(ScanOut, PicturesArePlacedInTheMiddleAsLargeAsAsked) {
  const auto at = [](Extent picture, Extent screen, Scaling scaling) {
    return place_picture(picture, screen, scaling);
  };
  EXPECT_EQ(at({320, 240}, {1920, 1080}, Scaling::kFitted), (PixelRect{240, 0, 1440, 1080}));
  EXPECT_EQ(at({320, 240}, {1920, 1080}, Scaling::kInteger), (PixelRect{320, 60, 1280, 960}));
  EXPECT_EQ(at({800, 480}, {320, 240}, Scaling::kFitted), (PixelRect{0, 24, 320, 192}));
  EXPECT_EQ(at({800, 480}, {320, 240}, Scaling::kInteger), (PixelRect{0, 24, 320, 192}))
      << "the screen is smaller";
  EXPECT_EQ(at({800, 480}, {800, 480}, Scaling::kInteger), (PixelRect{0, 0, 800, 480}));
  EXPECT_EQ(at({10000, 1}, {100, 100}, Scaling::kFitted), (PixelRect{0, 49, 100, 1})) << "never empty";
}

TEST(ScanOut, DitheredShadesKeepTheirMean) {
  const PixelLayout layout{16, {11, 5}, {5, 6}, {0, 5}, 0};
  for (int value = 0; value < 256; ++value) {
    const SurfaceMemory picture(8, 8, PixelFormat::kXrgb8888);
    const auto shade = static_cast<std::uint8_t>(value);
    fill_rect(picture.surface(), {0, 0, 8, 8}, {shade, shade, shade});
    const SurfaceMemory screen(8, 8, PixelFormat::kRgb565);
    ScanOut({8, 8}, {8, 8, screen.surface().stride_bytes, layout}, 0, Scaling::kFitted)
        .copy(picture.surface(), screen.surface().pixels);
    double red = 0.0;
    double green = 0.0;
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        red += read_pixel(screen.surface(), x, y).r / 64.0;
        green += read_pixel(screen.surface(), x, y).g / 64.0;
      }
    }
    // Half a step of the pattern, and half of one of read_pixel()'s rounding to 8 bits.
    EXPECT_NEAR(red, value, 255.0 / 31 / 128 + 0.5 + 0.1) << value;
    EXPECT_NEAR(green, value, 255.0 / 63 / 128 + 0.5 + 0.1) << value;
    if (value == 0 || value == 255) {
      EXPECT_EQ(red, value);
    }
  }
}

TEST(PixelLayout, WhatCannotBeWrittenIsSaid) {
  for (const NamedLayout& named : kLayouts) EXPECT_EQ(layout_problem(named.layout), "") << named.name;
  EXPECT_EQ(layout_problem({8, {0, 8}, {0, 8}, {0, 8}, 0}), "it has 8 bits a pixel");
  EXPECT_NE(layout_problem({16, {11, 5}, {5, 6}, {0, 0}, 0}), "") << "no blue";
  EXPECT_NE(layout_problem({16, {12, 5}, {5, 6}, {0, 5}, 0}), "") << "beyond the word";
  EXPECT_NE(layout_problem({32, {-1, 8}, {8, 8}, {16, 8}, 0}), "");
  EXPECT_NE(layout_problem({32, {0, 8}, {7, 8}, {16, 8}, 0}), "") << "shared bits";
  EXPECT_NE(layout_problem({32, {0, std::numeric_limits<int>::max()}, {8, 8}, {16, 8}, 0}), "");
  EXPECT_EQ(layout_text({16, {11, 5}, {5, 6}, {0, 5}, 0}), "16 bits: red 11+5, green 5+6, blue 0+5");
}

}  // namespace
}  // namespace vitrine
