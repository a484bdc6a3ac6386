// The formats of KMS: each one's layout against its definition, and which is used of those offered.
#include "drm_format.h"

#include <set>
#include <string_view>

#include <drm_fourcc.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

std::string_view chosen(std::initializer_list<std::uint32_t> offered, int preferred_bits,
                        std::optional<PixelFormat> kind) {
  const DrmFormat* const format = choose_format({offered.begin(), offered.size()}, preferred_bits, kind);
  return format == nullptr ? "none" : format->name;
}

TEST(DrmFormat, LayoutsAreAsTheNamesSay) {
  // "XRGB8888": the colours from the highest bit down, then as many lengths.
  std::set<std::uint32_t> codes;
  for (const DrmFormat& format : drm_formats()) {
    EXPECT_TRUE(codes.insert(format.code).second) << format.name;
    EXPECT_EQ(layout_problem(format.layout), "") << format.name;
    const std::size_t colours = format.name.find_first_of("0123456789");
    int at = 0;
    for (std::size_t i = colours; i-- > 0;) {
      const int length = format.name[colours + i] - '0';
      const BitField field{at, length};
      switch (format.name[i]) {
        case 'R':
          EXPECT_EQ(format.layout.red, field) << format.name;
          break;
        case 'G':
          EXPECT_EQ(format.layout.green, field) << format.name;
          break;
        case 'B':
          EXPECT_EQ(format.layout.blue, field) << format.name;
          break;
        case 'A':
          EXPECT_EQ(format.layout.always_set, 0xffU << at) << format.name;
          break;
        default:
          EXPECT_EQ(format.layout.always_set, 0U) << format.name;
      }
      at += length;
    }
    EXPECT_EQ(at, format.layout.bits_per_pixel) << format.name;
  }
}

TEST(DrmFormat, TheBestOfThoseOffered) {
  const std::initializer_list<std::uint32_t> cirrus = {DRM_FORMAT_RGB565, DRM_FORMAT_RGB888,
                                                       DRM_FORMAT_XRGB8888};
  EXPECT_EQ(chosen(cirrus, 24, {}), "XRGB8888");
  EXPECT_EQ(chosen(cirrus, 16, {}), "RGB565") << "the driver prefers it";
  EXPECT_EQ(chosen(cirrus, 16, PixelFormat::kXrgb8888), "XRGB8888") << "it was asked for";
  EXPECT_EQ(chosen(cirrus, 32, PixelFormat::kRgb888), "RGB888");
  EXPECT_EQ(chosen({DRM_FORMAT_RGB565}, 24, {}), "RGB565") << "there is no other";
  EXPECT_EQ(chosen({DRM_FORMAT_RGB565}, 24, PixelFormat::kXrgb8888), "RGB565");
  EXPECT_EQ(chosen({DRM_FORMAT_XBGR8888, DRM_FORMAT_NV12}, 0, {}), "XBGR8888");
  EXPECT_EQ(chosen({DRM_FORMAT_NV12, DRM_FORMAT_C8}, 0, {}), "none");
  EXPECT_EQ(chosen({}, 0, {}), "none");
}

}  // namespace
}  // namespace vitrine
