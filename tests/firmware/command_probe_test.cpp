// What the probe prints of an invented machine, and of one with nothing.
#include "command_probe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

using testing::HasSubstr;
using testing::Not;

Inventory board() {
  Inventory inventory;
  inventory.screens.cards.push_back(
      {.path = "/dev/dri/card1",
       .driver = "vc4",
       .bus = "platform gpu",
       .formats = {"XRGB8888", "RGB565"},
       .connectors = {{"HDMI-A-1", Plugged::kYes, {{1920, 1080, 60.0, true}, {640, 480, 59.94}}},
                      {"HDMI-A-2", Plugged::kNo, {}}}});
  inventory.screens.framebuffers.push_back(
      {.path = "/dev/fb1", .id = "fb_ili9341", .width = 320, .height = 240});
  GpioInventory gpio;
  gpio.chips.push_back({"/dev/gpiochip0",
                        "gpiochip0",
                        "pinctrl-test",
                        {{.offset = 0, .name = "", .consumer = {}},
                         {.offset = 1, .name = "GPIO1", .consumer = "spi0 CS0", .used = true, .output = true},
                         {.offset = 2, .name = "GPIO2", .consumer = {}},
                         {.offset = 3, .name = "TWICE", .consumer = {}}}});
  gpio.chips.push_back({"/dev/gpiochip1",
                        "gpiochip1",
                        "expander",
                        {{.offset = 0, .name = "TWICE", .consumer = {}, .used = true}}});
  gpio.problems.emplace_back("/dev/gpiochip2: Permission denied; add the user to the group 'gpio'");
  inventory.buttons.gpio = gpio;
  InputInventory input;
  input.devices.push_back({.device = {.node = "/dev/input/event0", .name = "gpio-keys"},
                           .unused = "",
                           .codes = {"KEY_S"},
                           .links = {"/dev/input/by-path/platform-keys-event"}});
  input.devices.push_back({.device = {.node = "/dev/input/event1", .name = "mouse"},
                           .unused = "a pointer",
                           .codes = {},
                           .links = {}});
  inventory.buttons.input = input;
  return inventory;
}

TEST(Probe, TellsScreensPinsAndDevicesAsAConfigurationNamesThem) {
  const std::string text = probe_text(board());
  EXPECT_THAT(text, HasSubstr("card = \"vc4\""));
  EXPECT_THAT(text, HasSubstr("connector = \"HDMI-A-1\"  a screen: 1920x1080@60 (preferred), 640x480@"));
  EXPECT_THAT(text, HasSubstr("connector = \"HDMI-A-2\"  nothing plugged in\n"));
  EXPECT_THAT(text, HasSubstr("device = \"fb_ili9341\"  320x240"));
  EXPECT_THAT(text, HasSubstr("gpiochip0 (pinctrl-test), 4 lines"));
  EXPECT_THAT(text, HasSubstr("used by spi0 CS0"));
  EXPECT_THAT(text, HasSubstr("chip = \"pinctrl-test\", line = 0\n"));
  EXPECT_THAT(text, HasSubstr("free                    line = \"GPIO2\"\n"));
  EXPECT_THAT(text, HasSubstr("chip = \"pinctrl-test\", line = 3\n")) << "the name is not unique";
  EXPECT_THAT(
      text, HasSubstr("    [[gpio]]\n    button = \"scene\"\n    line = \"GPIO2\"\n    active_low = true\n"));
  EXPECT_THAT(text, HasSubstr("the group 'gpio'"));
  EXPECT_THAT(
      text,
      HasSubstr("name = \"gpio-keys\"\n    used\n    /dev/input/by-path/platform-keys-event\n    KEY_S\n"));
  EXPECT_THAT(text, HasSubstr("not used unless named: a pointer"));
}

TEST(Probe, AMachineWithNothingSaysSo) {
  Inventory nothing;
  nothing.buttons = {.gpio = GpioInventory{}, .input = InputInventory{}};
  const std::string text = probe_text(nothing);
  EXPECT_THAT(text, HasSubstr("neither a card"));
  EXPECT_THAT(text, HasSubstr("no /dev/gpiochip0"));
  EXPECT_THAT(text, HasSubstr("no /dev/input/event0"));
  EXPECT_THAT(text, Not(HasSubstr("[[gpio]]")));
}

TEST(Probe, ABuildWithoutBackendsSaysThatItDidNotLook) {
  EXPECT_THAT(probe_text({}), HasSubstr("this build has no gpio"));
  EXPECT_THAT(probe_text({}), HasSubstr("this build has no evdev"));
  EXPECT_TRUE(probe_json({})["gpio_chips"].is_null());
  EXPECT_TRUE(probe_json({})["input_devices"].is_null());
}

TEST(Probe, TheJsonHasAllOfIt) {
  const Json json = probe_json(board());
  EXPECT_EQ(json["cards"][0]["connectors"][0]["modes"].size(), 2U);
  EXPECT_EQ(json["cards"][0]["connectors"][1]["plugged"], false);
  EXPECT_EQ(json["framebuffers"][0]["id"], "fb_ili9341");
  EXPECT_EQ(json["gpio_chips"][0]["lines"][1]["free"], false);
  EXPECT_EQ(json["gpio_chips"][0]["lines"][1]["direction"], "output");
  EXPECT_EQ(json["gpio_chips"][0]["lines"][2]["config"], "line = \"GPIO2\"");
  EXPECT_EQ(json["input_devices"][1]["used"], false);
  EXPECT_EQ(json["input_devices"][1]["why_not"], "a pointer");
  EXPECT_EQ(json["problems"].size(), 1U);
}

}  // namespace
}  // namespace vitrine
