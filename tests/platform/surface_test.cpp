// Pixels in every format: what is written is read back, clipping holds, and the bytes between rows stay
// untouched.
#include "surface.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <tuple>

#include <gtest/gtest.h>

#include "headless_display.h"

namespace vitrine {
namespace {

constexpr std::byte kGuard{0xA5};

class SurfaceFormats : public testing::TestWithParam<PixelFormat> {
 protected:
  /// Marks the padding behind every row.
  static void guard(const Surface& surface) {
    for (int y = 0; y < surface.height; ++y) std::fill_n(padding(surface, y), padding_bytes(surface), kGuard);
  }
  static bool guarded(const Surface& surface) {
    for (int y = 0; y < surface.height; ++y) {
      const std::byte* begin = padding(surface, y);
      if (!std::all_of(begin, begin + padding_bytes(surface), [](std::byte b) { return b == kGuard; })) {
        return false;
      }
    }
    return true;
  }
  static std::size_t row_bytes(const Surface& surface) {
    return static_cast<std::size_t>(surface.width) *
           static_cast<std::size_t>(bytes_per_pixel(surface.format));
  }
  static std::size_t padding_bytes(const Surface& surface) {
    return surface.stride_bytes - row_bytes(surface);
  }
  static std::byte* padding(const Surface& surface, int y) {
    return surface.pixels + static_cast<std::size_t>(y) * surface.stride_bytes + row_bytes(surface);
  }
  /// What the format makes of a colour.
  static Rgb8 stored(Rgb8 c) {
    if (GetParam() != PixelFormat::kRgb565) return c;
    const auto through = [](int value, int max) {
      const int code = (2 * value * max + 255) / 510;
      return static_cast<std::uint8_t>((2 * code * 255 + max) / (2 * max));
    };
    return {through(c.r, 31), through(c.g, 63), through(c.b, 31)};
  }
};

INSTANTIATE_TEST_SUITE_P(All, SurfaceFormats,
                         testing::Values(PixelFormat::kXrgb8888, PixelFormat::kRgb888, PixelFormat::kRgb565));

TEST_P(SurfaceFormats, RowsAreReadBackAndPaddingIsKept) {
  HeadlessDisplay display(37, 16, GetParam());
  const Surface surface = display.acquire();
  ASSERT_GT(padding_bytes(surface), 0U) << "a stride that equals the width hides bugs";
  guard(surface);
  std::array<std::uint8_t, 37 * 3> row{};
  for (int y = 0; y < 16; ++y) {
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = static_cast<std::uint8_t>(i * 7 + static_cast<std::size_t>(y) * 31);
    write_rgb_row(surface, 0, y, row);
  }
  display.present();
  const Surface shown = display.shown();
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 37; ++x) {
      const auto value = [&](int channel) {
        return static_cast<std::uint8_t>((3 * x + channel) * 7 + y * 31);
      };
      ASSERT_EQ(read_pixel(shown, x, y), stored({value(0), value(1), value(2)})) << x << "," << y;
    }
  }
  EXPECT_TRUE(guarded(shown));
}

TEST_P(SurfaceFormats, ReadingAndWritingAgainChangesNothing) {
  const SurfaceMemory memory(256, 1, GetParam());
  for (int i = 0; i < 256; ++i) {
    const auto v = static_cast<std::uint8_t>(i);
    const auto w = static_cast<std::uint8_t>(255 - i);
    fill_rect(memory.surface(), {i, 0, 1, 1}, {v, w, v});
    const Rgb8 once = read_pixel(memory.surface(), i, 0);
    fill_rect(memory.surface(), {i, 0, 1, 1}, once);
    EXPECT_EQ(read_pixel(memory.surface(), i, 0), once);
  }
}

TEST_P(SurfaceFormats, DrawingIsClipped) {
  const SurfaceMemory memory(20, 10, GetParam());
  const Surface& surface = memory.surface();
  guard(surface);
  const std::array<std::uint8_t, 30 * 3> white = [] {
    std::array<std::uint8_t, 30 * 3> bytes{};
    bytes.fill(255);
    return bytes;
  }();
  write_rgb_row(surface, -5, 2, white);  // covers the row and hangs over both ends
  write_rgb_row(surface, 18, 3, white);
  write_rgb_row(surface, -28, 4, white);
  for (const int x : {-30, 20, 1000}) write_rgb_row(surface, x, 5, white);
  for (const int y : {-1, 10}) write_rgb_row(surface, 0, y, white);
  fill_rect(surface, {-4, 8, 6, 100}, {255, 255, 255});
  fill_rect(surface, {25, 0, 4, 4}, {255, 255, 255});
  fill_rect(surface, {0, 0, -3, 4}, {255, 255, 255});
  fill_rounded_rect(surface, {15, -9, 40, 10}, 4, {255, 255, 255});
  EXPECT_TRUE(guarded(surface));

  const auto expected_white = [](int x, int y) {
    return y == 2 || (y == 3 && x >= 18) || (y == 4 && x < 2) || (y >= 8 && x < 2);
  };
  for (int y = 1; y < 10; ++y) {  // row 0 is the rounded rectangle's
    for (int x = 0; x < 20; ++x) {
      const std::uint8_t level = expected_white(x, y) ? 255 : 0;
      EXPECT_EQ(read_pixel(surface, x, y), (Rgb8{level, level, level})) << x << "," << y;
    }
  }
}

TEST_P(SurfaceFormats, CoverageMixes) {
  const SurfaceMemory memory(3, 1, GetParam());
  fill_rect(memory.surface(), {0, 0, 3, 1}, {200, 100, 0});
  blend_pixel(memory.surface(), 0, 0, {0, 0, 255}, 0);
  blend_pixel(memory.surface(), 1, 0, {0, 0, 255}, 128);
  blend_pixel(memory.surface(), 2, 0, {0, 0, 255}, 255);
  EXPECT_EQ(read_pixel(memory.surface(), 0, 0), stored({200, 100, 0}));
  const Rgb8 half = read_pixel(memory.surface(), 1, 0);
  EXPECT_NEAR(half.r, 100, 6);
  EXPECT_NEAR(half.g, 50, 6);
  EXPECT_NEAR(half.b, 128, 6);
  EXPECT_EQ(read_pixel(memory.surface(), 2, 0), stored({0, 0, 255}));
}

TEST(Surface, WordsHaveTheDocumentedBits) {
  const SurfaceMemory wide(1, 1, PixelFormat::kXrgb8888);
  fill_rect(wide.surface(), {0, 0, 1, 1}, {0x12, 0x34, 0x56});
  std::uint32_t word = 0;
  std::memcpy(&word, wide.surface().pixels, sizeof word);
  EXPECT_EQ(word, 0x00123456U);

  const SurfaceMemory narrow(1, 1, PixelFormat::kRgb565);
  fill_rect(narrow.surface(), {0, 0, 1, 1}, {255, 0, 0});
  std::uint16_t half = 0;
  std::memcpy(&half, narrow.surface().pixels, sizeof half);
  EXPECT_EQ(half, 0xF800U);
  fill_rect(narrow.surface(), {0, 0, 1, 1}, {0, 255, 255});
  std::memcpy(&half, narrow.surface().pixels, sizeof half);
  EXPECT_EQ(half, 0x07FFU);
}

TEST(Surface, RoundedCornersAreRoundAndSymmetric) {
  const SurfaceMemory memory(24, 24, PixelFormat::kRgb888);
  const Surface& surface = memory.surface();
  fill_rounded_rect(surface, {2, 2, 20, 20}, 8, {255, 255, 255});
  EXPECT_EQ(read_pixel(surface, 2, 2), (Rgb8{0, 0, 0}));
  EXPECT_EQ(read_pixel(surface, 12, 2), (Rgb8{255, 255, 255}));
  double area = 0.0;
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 24; ++x) {
      const Rgb8 pixel = read_pixel(surface, x, y);
      area += pixel.r / 255.0;
      EXPECT_EQ(pixel, read_pixel(surface, 23 - x, y));
      EXPECT_EQ(pixel, read_pixel(surface, x, 23 - y));
      EXPECT_EQ(pixel, read_pixel(surface, y, x));
    }
  }
  EXPECT_NEAR(area, 400.0 - (4.0 - 3.14159265) * 64.0, 2.0);
}

TEST(Surface, ImpossibleSizesAreRefused) {
  for (const auto& [width, height] : {std::tuple{0, 5}, {5, -1}, {20000, 5}}) {
    EXPECT_THROW(SurfaceMemory(width, height, PixelFormat::kRgb888), std::runtime_error);
  }
}

}  // namespace
}  // namespace vitrine
