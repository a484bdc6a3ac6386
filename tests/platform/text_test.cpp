// Text: it leaves ink where it should, never outside, and the same ink every time.
#include "text.h"

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace vitrine {
namespace {

constexpr Rgb8 kWhite{255, 255, 255};

std::vector<std::byte> bytes_of(const Surface& surface) {
  return {surface.pixels, surface.pixels + surface.stride_bytes * static_cast<std::size_t>(surface.height)};
}

std::vector<std::byte> drawn(int x, int y, int size_px, std::string_view text) {
  const SurfaceMemory memory(160, 40, PixelFormat::kXrgb8888);
  draw_text(memory.surface(), x, y, size_px, kWhite, text);
  return bytes_of(memory.surface());
}

/// The sum of all pixels, in whole white pixels, and the smallest rectangle that holds them.
struct Ink {
  double amount = 0.0;
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
};

Ink ink_of(const Surface& surface) {
  Ink ink;
  for (int y = 0; y < surface.height; ++y) {
    for (int x = 0; x < surface.width; ++x) {
      const int level = read_pixel(surface, x, y).g;
      if (level == 0) continue;
      ink.amount += level / 255.0;
      ink.left = std::min(ink.left, x);
      ink.right = std::max(ink.right, x);
      ink.top = std::min(ink.top, y);
      ink.bottom = std::max(ink.bottom, y);
    }
  }
  return ink;
}

TEST(Text, StaysInItsLineBox) {
  for (const int size : {8, 11, 15, 24, 48}) {
    const std::string text = "Sampling: \u00c4gypt, 32 spp (60 fps)";
    const int width = text_width(size, text);
    const int height = text_height(size);
    const SurfaceMemory memory(width + 20, height + 20, PixelFormat::kRgb888);
    draw_text(memory.surface(), 10, 10, size, kWhite, text);
    const Ink ink = ink_of(memory.surface());
    EXPECT_GE(ink.left, 10);
    EXPECT_LT(ink.right, 10 + width);
    EXPECT_GT(ink.right, 10 + width - size) << "the width is that of the ink";
    EXPECT_GE(ink.top, 10);
    EXPECT_LT(ink.bottom, 10 + height);
  }
}

TEST(Text, AnHIsAsTallAsDejaVuSaysAndItsEdgesAreSmooth) {
  const SurfaceMemory memory(100, 120, PixelFormat::kRgb888);
  draw_text(memory.surface(), 10, 5, 100, kWhite, "H");
  const Ink ink = ink_of(memory.surface());
  EXPECT_NEAR(ink.bottom - ink.top + 1, 73, 1);  // capital height: 1493 of 2048 units
  EXPECT_GT(ink.amount, 1000.0);
  int partial = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 100; ++x) {
      const int level = read_pixel(memory.surface(), x, y).g;
      partial += level > 0 && level < 255 ? 1 : 0;
    }
  }
  EXPECT_GT(partial, 20);
}

TEST(Text, IsClippedAtEveryBorder) {
  constexpr int kSide = 40;
  const std::string text = "Wg\u00c5j";
  const int size = 30;
  const SurfaceMemory whole(400, 400, PixelFormat::kXrgb8888);
  for (const PixelFormat format : {PixelFormat::kXrgb8888, PixelFormat::kRgb888, PixelFormat::kRgb565}) {
    for (int y = -50; y <= kSide + 10; y += 15) {
      for (int x = -120; x <= kSide + 10; x += 17) {
        // Exact memory, no padding: one byte too far is out of the vector.
        const std::size_t stride = kSide * static_cast<std::size_t>(bytes_per_pixel(format));
        std::vector<std::byte> bytes(stride * kSide);
        const Surface small{bytes.data(), kSide, kSide, stride, format};
        draw_text(small, x, y, size, kWhite, text);
        fill_rect(whole.surface(), {0, 0, 400, 400}, {});
        draw_text(whole.surface(), x + 150, y + 150, size, kWhite, text);
        for (int j = 0; j < kSide; ++j) {
          for (int i = 0; i < kSide; ++i) {
            const int expected = read_pixel(whole.surface(), i + 150, j + 150).g;
            ASSERT_NEAR(read_pixel(small, i, j).g, expected, format == PixelFormat::kRgb565 ? 2 : 0);
          }
        }
      }
    }
  }
}

TEST(Text, TakesItsColourAndKeepsTheBackground) {
  const SurfaceMemory memory(60, 60, PixelFormat::kRgb888);
  fill_rect(memory.surface(), {0, 0, 60, 60}, {10, 60, 10});
  draw_text(memory.surface(), 5, 5, 50, {250, 200, 10}, "\u2588");  // a full block
  EXPECT_EQ(read_pixel(memory.surface(), 20, 30), (Rgb8{250, 200, 10}));
  EXPECT_EQ(read_pixel(memory.surface(), 58, 30), (Rgb8{10, 60, 10}));
}

TEST(Text, IsTheSameEveryTimeAndInEveryThread) {
  const auto reference = drawn(3, 3, 17, "frame 1234");
  EXPECT_EQ(drawn(3, 3, 17, "frame 1234"), reference);
  EXPECT_NE(drawn(3, 3, 17, "frame 1235"), reference);
  std::vector<std::vector<std::byte>> pictures(4);
  std::vector<std::thread> threads;
  for (auto& picture : pictures) {
    threads.emplace_back([&picture] {
      for (int size = 9; size < 40; ++size) picture = drawn(3, 3, size, "frame 1234");
      picture = drawn(3, 3, 17, "frame 1234");
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& picture : pictures) EXPECT_EQ(picture, reference);
}

TEST(Text, ReadsUtf8) {
  EXPECT_NE(drawn(2, 2, 20, "\u00e9"), drawn(2, 2, 20, "e"));
  EXPECT_NE(drawn(2, 2, 20, "\u2192"), drawn(2, 2, 20, "\u2190"));
  EXPECT_EQ(text_width(20, ""), 0);
  EXPECT_EQ(text_width(20, "\u00d7"), text_width(20, "+")) << "mathematical signs share one width";
}

TEST(Text, ShowsBrokenAndUnknownCharactersAsReplacements) {
  const auto replacement = drawn(2, 2, 20, "\uFFFD");
  for (const std::string_view broken : {"\xFF", "\x80", "\xC3", "\xE2\x82", "\xC0", "\xF5"}) {
    SCOPED_TRACE(testing::PrintToString(broken));
    const auto picture = drawn(2, 2, 20, broken);
    const auto doubled = drawn(2, 2, 20, "\uFFFD\uFFFD");
    EXPECT_TRUE(picture == replacement || picture == doubled);
  }
  EXPECT_EQ(drawn(2, 2, 20, "\xED\xA0\x80"), drawn(2, 2, 20, "\uFFFD\uFFFD\uFFFD")) << "a surrogate";
  EXPECT_EQ(drawn(2, 2, 20, "\xE0\x80\x80"), drawn(2, 2, 20, "\uFFFD\uFFFD\uFFFD")) << "too long a form";
  EXPECT_EQ(drawn(2, 2, 20, "\U000F1234"), replacement) << "not in the font";
  EXPECT_EQ(drawn(2, 2, 20,
                  std::string_view("\xC3"
                                   "A")),
            drawn(2, 2, 20,
                  "\uFFFD"
                  "A"));
}

}  // namespace
}  // namespace vitrine
