// Lines by name, label and offset on an invented board, and what is said when they are not there.
#include "gpio_places.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace vitrine {
namespace {

GpioInventory board() {
  GpioInventory inventory;
  inventory.chips.push_back({"/dev/gpiochip0", "gpiochip0", "pinctrl-test", {}});
  for (unsigned i = 0; i < 28; ++i)
    inventory.chips[0].lines.push_back(
        {.offset = i, .name = i < 2 ? "" : "GPIO" + std::to_string(i), .consumer = {}});
  inventory.chips.push_back({"/dev/gpiochip1",
                             "gpiochip1",
                             "expander",
                             {{.offset = 0, .name = "KNOB", .consumer = {}},
                              {.offset = 1, .name = "7", .consumer = {}},
                              {.offset = 2, .name = "GPIO27", .consumer = {}}}});
  return inventory;
}

GpioLine wired(std::string chip, std::string line) {
  GpioLine wire;
  wire.button = "scene";
  wire.chip = std::move(chip);
  wire.line = std::move(line);
  return wire;
}

std::string place(const std::string& chip, const std::string& line,
                  const GpioInventory& inventory = board()) {
  try {
    const GpioPlace found = find_line(wired(chip, line), inventory);
    return found.chip.string() + " " + std::to_string(found.offset);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(GpioPlaces, ALineIsFoundByItsName) {
  EXPECT_EQ(place("", "GPIO17"), "/dev/gpiochip0 17");
  EXPECT_EQ(place("", "KNOB"), "/dev/gpiochip1 0");
  EXPECT_EQ(place("expander", "GPIO27"), "/dev/gpiochip1 2");
}

TEST(GpioPlaces, AChipIsFoundByLabelNameOrPath) {
  for (const char* chip : {"pinctrl-test", "gpiochip0", "/dev/gpiochip0"}) {
    EXPECT_EQ(place(chip, "0"), "/dev/gpiochip0 0");
    EXPECT_EQ(place(chip, "GPIO5"), "/dev/gpiochip0 5");
  }
}

TEST(GpioPlaces, ANameThatIsANumberGoesBeforeTheOffset) {
  EXPECT_EQ(place("expander", "7"), "/dev/gpiochip1 1");
}

TEST(GpioPlaces, WhatIsNotThereIsToldWithWhatIs) {
  EXPECT_EQ(
      place("pinctrl-tset", "4"),
      "button 'scene': no GPIO chip is called 'pinctrl-tset'; there are gpiochip0 (pinctrl-test), gpiochip1 "
      "(expander)");
  EXPECT_TRUE(
      place("", "GPO17")
          .starts_with("button 'scene': no line of any GPIO chip is named 'GPO17'; the nearest are GPIO17, "))
      << place("", "GPO17");
  EXPECT_EQ(place("gpiochip0", "28"),
            "button 'scene': gpiochip0 (pinctrl-test) has no line 28; it has 0 to 27");
  EXPECT_EQ(place("", "17"),
            "button 'scene': line 17 is a number; name its chip, too: gpiochip0 (pinctrl-test), gpiochip1 "
            "(expander)");
  EXPECT_EQ(
      place("", "GPIO27"),
      "button 'scene': 'GPIO27' is ambiguous: gpiochip0 line 27, gpiochip1 line 2; give chip and offset");
}

TEST(GpioPlaces, AMachineWithoutChipsOrRightsSaysSo) {
  EXPECT_EQ(
      place("", "GPIO17", {}),
      "button 'scene': this machine shows no GPIO chip (/dev/gpiochip0); see that its driver is loaded");
  EXPECT_EQ(
      place("", "GPIO17", {{}, {"/dev/gpiochip0: Permission denied; add the user to the group 'gpio'"}}),
      "button 'scene': /dev/gpiochip0: Permission denied; add the user to the group 'gpio'");
}

}  // namespace
}  // namespace vitrine
