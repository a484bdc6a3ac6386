// Which input devices are buttons, and the names of keys.
#include "input_devices.h"

#include <stdexcept>

#include <gtest/gtest.h>
#include <linux/input.h>

namespace vitrine {
namespace {

const std::vector<ButtonSpec> kBox = {{"scene", "Scene", "Right"}, {"compare", "Compare", "S"},
                                      {"split", "", ","},          {"pause", "", "Space"},
                                      {"quit", "", "Escape"},      {"odd", "", "Wheel 7"}};

InputDevice device(std::set<unsigned> keys, std::set<unsigned> axes = {}, std::string name = "thing") {
  InputDevice made;
  made.name = std::move(name);
  made.keys = std::move(keys);
  made.axes = std::move(axes);
  return made;
}

TEST(InputDevices, TheKeysOfTheSimulatedBoxAreThoseOfAPlainKeyboard) {
  const InputMap expected = {{{EV_KEY, KEY_RIGHT, 0}, "scene"},
                             {{EV_KEY, KEY_S, 0}, "compare"},
                             {{EV_KEY, KEY_COMMA, 0}, "split"},
                             {{EV_KEY, KEY_SPACE, 0}, "pause"},
                             {{EV_KEY, KEY_ESC, 0}, "quit"}};
  EXPECT_EQ(input_map(kBox), expected);
}

TEST(InputDevices, AConfigurationNamesKeysAndSteps) {
  EvdevDevice knob;
  knob.keys = {{"REL_X+", "scene"}, {"REL_X-", "scene-back"}, {"BTN_0", "mode"}};
  const InputMap expected = {
      {{EV_REL, REL_X, 1}, "scene"}, {{EV_REL, REL_X, -1}, "scene-back"}, {{EV_KEY, BTN_0, 0}, "mode"}};
  EXPECT_EQ(input_map(knob), expected);
  for (const auto& [code, button] : input_map(knob)) EXPECT_EQ(knob.keys.at(name_of(code)), button);
}

TEST(InputDevices, AMistypedKeyIsToldWithTheNearest) {
  EvdevDevice knob;
  knob.name = "knob";
  knob.keys = {{"KEY_NEXTT", "scene"}};
  try {
    static_cast<void>(input_map(knob));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("KEY_NEXT,"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("'knob'"), std::string::npos) << error.what();
  }
}

TEST(InputDevices, KeyboardsAndKeysOnPinsAreButtons) {
  const InputMap map = input_map(kBox);
  EXPECT_EQ(why_unused(device({KEY_ESC, KEY_S, KEY_POWER}), map), "");
  EXPECT_EQ(why_unused(device({KEY_RIGHT}), map), "");
}

TEST(InputDevices, PointersRemoteControlsAndPowerButtonsAreNot) {
  const InputMap map = input_map(kBox);
  EXPECT_EQ(why_unused(device({BTN_LEFT, KEY_ESC}, {REL_X, REL_Y}), map), "a pointer");
  InputDevice touch = device({BTN_TOUCH, KEY_S});
  touch.positions = {ABS_X, ABS_Y};
  EXPECT_EQ(why_unused(touch, map), "a pointer");
  EXPECT_EQ(why_unused(device({KEY_RIGHT, KEY_SPACE}, {}, "vc4-hdmi-0 CEC"), map),
            "the remote control of the screen (CEC)");
  InputDevice remote = device({KEY_RIGHT});
  remote.bus = 0x1e;
  EXPECT_EQ(why_unused(remote, map), "the remote control of the screen (CEC)");
  EXPECT_EQ(why_unused(device({KEY_POWER}), map), "the power button");
  EXPECT_EQ(why_unused(device({}), map), "no keys and no steps");
  EXPECT_EQ(why_unused(device({KEY_F1}), map), "none of its keys is one of the box's");
  EXPECT_EQ(why_unused(device({}, {REL_X}), map), "none of its keys is one of the box's");
}

}  // namespace
}  // namespace vitrine
