// The choice of mode, connector and card: what is asked for when it is there, and what a person would take
// otherwise.
#include "screen_choice.h"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace vitrine {
namespace {

TEST(ScreenChoice, ModesAreRead) {
  const ModeWish plain = parse_mode("1920x1080");
  EXPECT_EQ(plain.width, 1920);
  EXPECT_EQ(plain.height, 1080);
  EXPECT_FALSE(plain.refresh_hz);
  const ModeWish exact = parse_mode("800x480@59.94");
  EXPECT_EQ(exact.width, 800);
  EXPECT_EQ(exact.height, 480);
  EXPECT_DOUBLE_EQ(exact.refresh_hz.value(), 59.94);
  for (const char* text :
       {"", "1920", "1920x", "x1080", "1920x1080@", "1920x1080@60Hz", "0x1080", "-1x5", "1920X1080",
        " 1920x1080", "99999999999x5", "20000x20", "800x480@0", "800x480@nan", "800x480@inf"}) {
    EXPECT_THROW(static_cast<void>(parse_mode(text)), std::runtime_error) << text;
  }
}

TEST(ScreenChoice, AModeIsWrittenAsItIsRead) {
  EXPECT_EQ(mode_text({.width = 1920, .height = 1080, .refresh_hz = 60.0}), "1920x1080@60");
  EXPECT_EQ(mode_text({.width = 800, .height = 480, .refresh_hz = 59.94006}), "800x480@59.94");
}

const std::vector<ScreenMode> kTelevision = {
    {.width = 1920, .height = 1080, .refresh_hz = 60.0, .interlaced = true},
    {.width = 1920, .height = 1080, .refresh_hz = 50.0},
    {.width = 1920, .height = 1080, .refresh_hz = 59.94},
    {.width = 1280, .height = 720, .refresh_hz = 60.0, .preferred = true},
    {.width = 720, .height = 576, .refresh_hz = 50.0},
    {.width = 4096, .height = 2160, .refresh_hz = 24.0},
};

TEST(ScreenChoice, TheModeThatTheScreenPrefers) {
  EXPECT_EQ(choose_mode(kTelevision, {}), 3U);
  std::vector<ScreenMode> undecided = kTelevision;
  undecided[3].preferred = false;
  EXPECT_EQ(choose_mode(undecided, {}), 2U) << "the largest that a board can fill";
  EXPECT_EQ(choose_mode({}, {}), std::nullopt);
}

TEST(ScreenChoice, AScreenThatPrefersNothingIsNotTakenForAWall) {
  // What the kernel makes of a small virtual monitor's EDID.
  std::vector<ScreenMode> modes = {
      {.width = 5120, .height = 2160, .refresh_hz = 50.0},
      {.width = 4096, .height = 2160, .refresh_hz = 60.0},
      {.width = 1920, .height = 1200, .refresh_hz = 60.0},
      {.width = 1280, .height = 1024, .refresh_hz = 60.0},
      {.width = 640, .height = 480, .refresh_hz = 60.0},
  };
  EXPECT_EQ(choose_mode(modes, {}), 3U);
  EXPECT_EQ(choose_mode(std::span(modes).first(3), {}), 2U) << "none is small: the smallest";
  EXPECT_EQ(choose_mode(modes, parse_mode("5120x2160")), 0U) << "it can still be asked for";
  modes[0].preferred = true;
  EXPECT_EQ(choose_mode(modes, {}), 0U) << "its own pixels";
  modes = {{.width = 1080, .height = 1920}, {.width = 640, .height = 480}};
  EXPECT_EQ(choose_mode(modes, {}), 0U) << "a panel that stands upright";
}

TEST(ScreenChoice, TheModeAskedFor) {
  EXPECT_EQ(choose_mode(kTelevision, parse_mode("1920x1080")), 2U) << "nearest to 60 Hz, not interlaced";
  EXPECT_EQ(choose_mode(kTelevision, parse_mode("1920x1080@60")), 2U) << "59.94 Hz is meant";
  EXPECT_EQ(choose_mode(kTelevision, parse_mode("1920x1080@50")), 1U);
  EXPECT_EQ(choose_mode(kTelevision, parse_mode("720x576")), 4U);
  EXPECT_EQ(choose_mode(kTelevision, parse_mode("1920x1080@75")), std::nullopt);
  EXPECT_EQ(choose_mode(kTelevision, parse_mode("640x480")), std::nullopt);
}

TEST(ScreenChoice, AConnectorWithAScreen) {
  const std::vector<ScreenMode> modes = {{.width = 640, .height = 480}};
  const std::vector<ConnectorInfo> connectors = {
      {"Composite-1", Plugged::kUnknown, modes}, {"HDMI-A-1", Plugged::kNo, modes},
      {"HDMI-A-2", Plugged::kYes, modes},        {"DSI-1", Plugged::kYes, modes},
      {"HDMI-A-3", Plugged::kYes, {}},
  };
  EXPECT_EQ(choose_connector(connectors, ""), 2U);
  EXPECT_EQ(choose_connector(connectors, "DSI-1"), 3U);
  EXPECT_EQ(choose_connector(connectors, "Composite-1"), 0U) << "named, it need not be sure";
  EXPECT_EQ(choose_connector(connectors, "HDMI-A-1"), std::nullopt) << "nothing is plugged in";
  EXPECT_EQ(choose_connector(connectors, "HDMI-A-3"), std::nullopt) << "no mode";
  EXPECT_EQ(choose_connector(connectors, "VGA-1"), std::nullopt);
  EXPECT_EQ(choose_connector(std::span(connectors).first(2), ""), 0U) << "better than none";
}

TEST(ScreenChoice, ACardByItsPathDriverOrPlace) {
  const CardInfo card{.path = "/dev/null", .driver = "vc4", .bus = "platform gpu"};
  for (const char* name : {"", "/dev/null", "/dev/./null", "vc4", "platform gpu"}) {
    EXPECT_TRUE(is_meant(card, name)) << name;
  }
  for (const char* name : {"/dev/zero", "/dev/nothing", "vc", "v3d", "gpu"})
    EXPECT_FALSE(is_meant(card, name)) << name;
}

TEST(ScreenChoice, AFramebufferByItsPathOrId) {
  const FramebufferInfo device{.path = "/dev/null", .id = "fb_ili9341"};
  for (const char* name : {"", "/dev/null", "/dev/./null", "fb_ili9341"})
    EXPECT_TRUE(is_meant(device, name)) << name;
  for (const char* name : {"/dev/zero", "fb", "null"}) EXPECT_FALSE(is_meant(device, name)) << name;
}

}  // namespace
}  // namespace vitrine
