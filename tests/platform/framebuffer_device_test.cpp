// What a framebuffer device says of itself, and which devices are refused; and the whole way through a real
// one where this machine has it.
#include "framebuffer_device.h"

#include <cstring>

#include <gtest/gtest.h>
#include <linux/fb.h>

namespace vitrine {
namespace {

/// A panel of 320x240 pixels in RGB565 with padded rows.
struct Device {
  Device() {
    std::strncpy(fixed.id, "fb_ili9341", sizeof fixed.id);
    fixed.type = FB_TYPE_PACKED_PIXELS;
    fixed.visual = FB_VISUAL_TRUECOLOR;
    fixed.line_length = 656;
    fixed.smem_len = 656 * 240;
    variable.xres = 320;
    variable.yres = 240;
    variable.bits_per_pixel = 16;
    variable.red = {11, 5, 0};
    variable.green = {5, 6, 0};
    variable.blue = {0, 5, 0};
  }
  [[nodiscard]] FramebufferInfo info() const { return framebuffer_info("/dev/fb1", fixed, variable); }

  fb_fix_screeninfo fixed{};
  fb_var_screeninfo variable{};
};

TEST(FramebufferDevice, IsBelieved) {
  const FramebufferInfo info = Device().info();
  EXPECT_EQ(info.problem, "");
  EXPECT_EQ(info.path, "/dev/fb1");
  EXPECT_EQ(info.id, "fb_ili9341");
  EXPECT_EQ(info.width, 320);
  EXPECT_EQ(info.height, 240);
  EXPECT_EQ(info.stride_bytes, 656U);
  EXPECT_EQ(info.layout, (PixelLayout{16, {11, 5}, {5, 6}, {0, 5}, 0}));
}

TEST(FramebufferDevice, RedAndBlueMayBeSwappedAndAPixelOpaque) {
  Device device;
  device.fixed.line_length = 1280;
  device.fixed.smem_len = 1280 * 240;
  device.variable.bits_per_pixel = 32;
  device.variable.red = {0, 8, 0};
  device.variable.green = {8, 8, 0};
  device.variable.blue = {16, 8, 0};
  device.variable.transp = {24, 8, 0};
  EXPECT_EQ(device.info().problem, "");
  EXPECT_EQ(device.info().layout, (PixelLayout{32, {0, 8}, {8, 8}, {16, 8}, 0xff000000}));
}

TEST(FramebufferDevice, AnIdNeedNotEnd) {
  Device device;
  std::memset(device.fixed.id, 'x', sizeof device.fixed.id);
  EXPECT_EQ(device.info().id, std::string(sizeof device.fixed.id, 'x'));
}

TEST(FramebufferDevice, IsRefusedWithARemedy) {
  const auto problem = [](auto change) {
    Device device;
    change(device);
    return device.info().problem;
  };
  EXPECT_EQ(problem([](Device& d) { d.variable.bits_per_pixel = 8; }),
            "/dev/fb1 (fb_ili9341) cannot show pictures: it has 8 bits a pixel; set 16, 24 or 32 bits by its "
            "driver's option or 'fbset -depth 32'");
  EXPECT_NE(problem([](Device& d) { d.fixed.visual = FB_VISUAL_PSEUDOCOLOR; }), "");
  EXPECT_NE(problem([](Device& d) { d.fixed.type = FB_TYPE_PLANES; }), "");
  EXPECT_NE(problem([](Device& d) { d.variable.grayscale = 1; }), "");
  EXPECT_NE(problem([](Device& d) { d.variable.red.length = 0; }), "");
  EXPECT_NE(problem([](Device& d) { d.fixed.line_length = 639; }), "") << "rows that overlap";
  EXPECT_NE(problem([](Device& d) { d.fixed.smem_len -= 1; }), "") << "the last row is not there";
  EXPECT_NE(problem([](Device& d) { d.variable.yoffset = 1; }), "") << "panned out of the memory";
  EXPECT_NE(problem([](Device& d) { d.variable.xoffset = 9; }), "") << "panned out of the row";
  EXPECT_NE(problem([](Device& d) { d.variable.yres = 0xffffffff; }), "");
  EXPECT_EQ(problem([](Device& d) { d.variable.xoffset = 8; }), "");
}

TEST(FramebufferDevice, OfThisMachineAreListed) {
  const ScreenInventory inventory = list_framebuffers();
  if (inventory.framebuffers.empty()) GTEST_SKIP() << "this machine has no /dev/fb*";
  for (const FramebufferInfo& info : inventory.framebuffers) {
    EXPECT_TRUE(info.path.starts_with("/dev/fb")) << info.path;
    const bool rows_fit = info.stride_bytes >= static_cast<std::size_t>(info.width);
    EXPECT_TRUE(rows_fit || !info.problem.empty()) << info.path;
  }
}

}  // namespace
}  // namespace vitrine
