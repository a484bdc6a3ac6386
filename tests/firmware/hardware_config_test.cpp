// What config and board files say about screen, wires and gestures; the files that we ship.
#include "hardware_config.h"

#include <algorithm>
#include <fstream>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backends.h"
#include "box_config.h"
#include "firmware/temporary_folder.h"
#include "scene/input_error.h"
#include "source_file.h"

namespace vitrine {
namespace {

using testing::HasSubstr;

BoxConfig read(const std::string& text, const std::string& board = "") {
  const TemporaryFolder folder;
  if (!board.empty()) (void)folder.write("board.toml", board);
  return read_box_config(folder.write("kiosk.toml", text));
}

std::string refusal(const std::string& text, const std::string& board = "") {
  try {
    (void)read(text, board);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(HardwareConfig, ReadsTheDisplay) {
  const BoxConfig box = read(
      "[display]\nbackend = 'drm'\ncard = 'vc4'\nconnector = 'DSI-1'\nmode = '800x480@60'\n"
      "device = '/dev/fb1'\nrotation = 270\nscaling = 'integer'\nformat = 'rgb565'\n");
  const DisplayOptions options = box.hardware.display.options();
  EXPECT_EQ(box.display_key(), "drm");
  EXPECT_EQ(options.card, "vc4");
  EXPECT_EQ(options.connector, "DSI-1");
  EXPECT_EQ(options.mode, "800x480@60");
  EXPECT_EQ(options.device, "/dev/fb1");
  EXPECT_EQ(options.rotation, 270);
  EXPECT_EQ(options.scaling, Scaling::kInteger);
  EXPECT_EQ(options.format, PixelFormat::kRgb565);
  EXPECT_EQ(read("display = 'headless'\n").display_key(), "headless");
  EXPECT_EQ(read("").display_key(), "auto");
}

TEST(HardwareConfig, ReadsWiresAndGestures) {
  const BoxConfig box = read(
      "[[gpio]]\nbutton = 'a'\nchip = 'pinctrl-bcm2711'\nline = 5\nactive_low = true\nbias = 'pull-up'\n"
      "debounce_ms = 7\n[[evdev]]\nname = 'knob'\ngrab = true\nkeys = {'REL_X+' = 'scene'}\n"
      "[[gesture]]\nbutton = 'a'\non = 'long'\naction = 'compare'\nafter_ms = 600\n"
      "[[gesture]]\nbuttons = ['a', 'scene']\naction = 'screenshot'\n");
  const ButtonWiring wiring = box.hardware.wiring();
  ASSERT_EQ(wiring.gpio.size(), 1U);
  EXPECT_EQ(wiring.gpio[0].button, "a");
  EXPECT_EQ(wiring.gpio[0].chip, "pinctrl-bcm2711");
  EXPECT_EQ(wiring.gpio[0].line, "5");
  EXPECT_TRUE(wiring.gpio[0].active_low);
  EXPECT_EQ(wiring.gpio[0].bias, Bias::kPullUp);
  EXPECT_EQ(wiring.gpio[0].debounce.count(), 7);
  ASSERT_EQ(wiring.evdev.size(), 1U);
  EXPECT_EQ(wiring.evdev[0].keys.at("REL_X+"), "scene");
  EXPECT_TRUE(wiring.evdev[0].grab);
  const std::vector<GestureRule> rules = box.hardware.rules();
  ASSERT_EQ(rules.size(), 2U);
  EXPECT_EQ(rules[0].kind, GestureKind::kLong);
  EXPECT_EQ(rules[0].after.count(), 600);
  EXPECT_EQ(rules[1].kind, GestureKind::kChord);
  EXPECT_EQ(box.hardware.wired_buttons(), (std::vector<std::string>{"a", "scene"}));
}

TEST(HardwareConfig, TheBoxGoesBeforeItsBoard) {
  const std::string board =
      "[display]\nrotation = 90\ncard = 'vc4'\n[[gpio]]\nbutton = 'scene'\nline = 'GPIO5'\n"
      "[[gpio]]\nbutton = 'y'\nline = 'GPIO24'\n[[gesture]]\nbutton = 'y'\naction = 'pause'\n";
  const BoxConfig box = read(
      "board = 'board.toml'\n[display]\nrotation = 180\n[[gpio]]\nbutton = 'y'\nline = 'GPIO20'\n"
      "[[gesture]]\nbutton = 'y'\naction = 'view'\n",
      board);
  EXPECT_EQ(box.hardware.display.rotation, 180);
  EXPECT_EQ(box.hardware.display.card, "vc4");
  ASSERT_EQ(box.hardware.gpio.size(), 2U);
  EXPECT_EQ(box.hardware.gpio[0].value.line, "GPIO20");
  EXPECT_EQ(box.hardware.gpio[1].value.line, "GPIO5");
  ASSERT_EQ(box.hardware.gestures.size(), 1U);
  EXPECT_EQ(box.hardware.gestures[0].value.action, "view");
}

TEST(HardwareConfig, SaysWhereItIsWrong) {
  EXPECT_THAT(refusal("[display]\nrotatoin = 90\n"),
              HasSubstr("line 2, column 1: unknown key 'rotatoin'; did"));
  EXPECT_THAT(refusal("[display]\nrotation = 45\n"), HasSubstr("write 0, 90, 180 or 270"));
  EXPECT_THAT(refusal("[display]\nbackend = 'dmr'\n"), HasSubstr("did you mean 'drm'?"));
  EXPECT_THAT(refusal("[[gpio]]\nbutton = 'scene'\nline = 5\n"), HasSubstr("an offset without a chip"));
  EXPECT_THAT(refusal("[[gpio]]\nbutton = 'scene'\n"), HasSubstr("line 1, column 1: this gpio has no line"));
  EXPECT_THAT(refusal("[[gpio]]\nbutton = 'a'\nline = 'X'\n"), HasSubstr("the button 'a' does nothing"));
  EXPECT_THAT(refusal("[[evdev]]\nkeys = {NEXT = 'scene'}\n"), HasSubstr("'NEXT' is no key"));
  EXPECT_THAT(refusal("[[gesture]]\nbutton = 'mode'\naction = 'screenshoot'\n"),
              HasSubstr("line 3, column 10: no action is named 'screenshoot'; did you mean 'screenshot'?"));
  EXPECT_THAT(refusal("[[gesture]]\nbutton = 'mdoe'\naction = 'scene'\n"),
              HasSubstr("no button is named 'mdoe'; did you mean 'mode'?"));
  EXPECT_THAT(refusal("[[gesture]]\nbutton = 'mode'\non = 'short'\nafter_ms = 5\naction = 'scene'\n"),
              HasSubstr("line 4"));
  EXPECT_THAT(refusal("[idle]\nevery_s = 3\n"), HasSubstr("every_s without after_s"));
  EXPECT_THAT(refusal("[[dim]]\nfrom = '22:61'\nto = '07:00'\nlevel = 0.2\n"),
              HasSubstr("is no time of day"));
  EXPECT_THAT(refusal("[governor]\nhot_c = 60\n"), HasSubstr("cool_c is not below hot_c"));
  EXPECT_THAT(refusal("[health]\nevery_s = 0\n"), HasSubstr("from 0.5 to 3600"));
  EXPECT_THAT(refusal("max_spp = 0\n"), HasSubstr("from 1 to 1048576"));
  EXPECT_THAT(refusal("board = 'none.toml'\n"), HasSubstr("no board file 'none.toml'"));
  EXPECT_THAT(refusal("board = 'board.toml'\n", "mode = 'nee'\n"), HasSubstr("unknown key 'mode'"));
}

TEST(HardwareConfig, AKeyThatNoDeviceHasIsToldBeforeOneIsThere) {
  if (std::ranges::find(buttons_backends(), "evdev", &ButtonsBackend::key) == buttons_backends().end())
    GTEST_SKIP() << "this build reads no input devices";
  EXPECT_THAT(
      refusal("[[evdev]]\n[evdev.keys]\nKEY_UP = 'scene'\nKEY_NEXTT = 'mode'\n"),
      HasSubstr("line 4, column 1: no key or axis step is called 'KEY_NEXTT'; the nearest are KEY_NEXT,"));
  EXPECT_THAT(refusal("[[evdev]]\nkeys = {REL_X = 'scene'}\n"), HasSubstr("the nearest are REL_X+, REL_X-"));
}

TEST(HardwareConfig, EveryBoardThatWeShipIsGood) {
  int boards = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_file("firmware/boards"))) {
    const HardwareConfig board = read_board(entry.path());
    EXPECT_NO_THROW(require_consistent(board)) << entry.path();
    EXPECT_FALSE(board.wired_buttons().empty()) << entry.path();
    ++boards;
  }
  EXPECT_GE(boards, 7);
}

/// The shipped config with every commented key in force.
TEST(HardwareConfig, EveryKeyThatTheShippedConfigExplainsIsGood) {
  std::ifstream file(source_file("firmware/kiosk.toml"));
  const std::regex commented("^# (\\[|[a-z_]+ = ).*");
  std::string text;
  for (std::string line; std::getline(file, line);)
    text += (std::regex_match(line, commented) ? line.substr(2) : line) + "\n";
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "boards");
  std::filesystem::copy(source_file("firmware/boards/hdmi-4-buttons.toml"), folder.path() / "boards");
  const BoxConfig box = read_box_config(folder.write("kiosk.toml", text));
  EXPECT_EQ(box.threads, 4);
  EXPECT_EQ(box.max_spp, 4096U);
  EXPECT_EQ(box.pixel_shift, true);
  ASSERT_TRUE(box.idle && box.governor && box.health);
  EXPECT_EQ(box.idle->after, std::chrono::seconds(120));
  EXPECT_EQ(box.idle->reset, std::chrono::seconds(90));
  ASSERT_EQ(box.dim.size(), 1U);
  EXPECT_EQ(box.dim[0], (DimSpan{std::chrono::hours(22), std::chrono::hours(7), 0.2}));
  EXPECT_EQ(box.governor->limits, (ThermalLimits{.hot_c = 80.0, .cool_c = 70.0}));
  EXPECT_EQ(box.health->file, folder.path() / "vitrine.prom");
}

}  // namespace
}  // namespace vitrine
