// The backend tables: every row opens what it says, and a wrong key or an absent source is told with a
// remedy.
#include "backends.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "script_buttons.h"
#include "surface.h"

namespace vitrine {
namespace {

using std::chrono::milliseconds;

const std::vector<ButtonSpec> kBox = {{"scene", "Scene", "S"}, {"quit", "", "Escape"}};

DisplayRequest request() { return {.width = 48, .height = 32, .title = "test", .buttons = kBox}; }

template <class Call>
std::string error_of(Call&& call) {
  try {
    static_cast<void>(call());
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Backends, KeysAreUniqueAndDescribed) {
  std::set<std::string_view> keys{"auto"};
  for (const DisplayBackend& row : display_backends()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_FALSE(row.description.empty()) << row.key;
  }
  keys = {"auto"};
  for (const ButtonsBackend& row : buttons_backends()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_FALSE(row.description.empty()) << row.key;
  }
  EXPECT_EQ(display_backends().back().key, "headless");
}

TEST(Backends, HeadlessHasTheSizeAskedForAndNoButtons) {
  const Panel panel = open_display("headless", request());
  EXPECT_EQ(panel.backend, "headless");
  EXPECT_EQ(panel.notice, "");
  EXPECT_EQ(panel.display->mode(), (DisplayMode{48, 32, PixelFormat::kXrgb8888}));
  EXPECT_EQ(panel.buttons, nullptr);
  const auto silent = open_buttons("auto", panel, {.buttons = kBox});
  const Clock::time_point start = Clock::now();
  EXPECT_TRUE(silent->poll(milliseconds{20}).empty());
  EXPECT_GE(Clock::now() - start, milliseconds{20}) << "without buttons poll() waits its time";
}

TEST(Backends, AutoFallsBackToMemoryAndSaysWhy) {
  for (const char* device : {"/dev/dri/card0", "/dev/dri/card1", "/dev/fb0"}) {
    if (std::filesystem::exists(device)) GTEST_SKIP() << "this machine has a screen that would be taken";
  }
  for (const char* session : {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"}) unsetenv(session);
  const Panel panel = open_display("auto", request());
  EXPECT_EQ(panel.backend, "headless");
  EXPECT_NE(panel.notice.find("'headless'"), std::string::npos) << panel.notice;
  if (display_backends().front().key == "sdl") {
    EXPECT_NE(panel.notice.find("sdl: no desktop session"), std::string::npos) << panel.notice;
    EXPECT_NE(error_of([] { return open_display("sdl", request()); }).find("no desktop session"),
              std::string::npos);
  }
}

TEST(Backends, WithoutASizeThereIsAUsualOne) {
  const Panel panel = open_display("headless", {});
  EXPECT_GT(panel.display->mode().width, 0);
  EXPECT_GT(panel.display->mode().height, 0);
}

// A box is often faster than its screen: the one that was named is waited for.
TEST(Backends, AScreenThatIsNamedIsWaitedFor) {
  for (const DisplayBackend& row : display_backends()) {
    if (row.list == nullptr) continue;
    DisplayRequest absent = request();
    absent.options.card = "/dev/no-such-card";
    absent.options.device = "/dev/no-such-framebuffer";
    EXPECT_THROW(static_cast<void>(row.open(absent)), DisplayUnavailable) << row.key;

    const Panel panel = open_display(row.key, absent);
    EXPECT_EQ(panel.backend, row.key);
    EXPECT_NE(panel.notice.find("no-such"), std::string::npos) << panel.notice;
    EXPECT_TRUE(panel.display->waiting_for_screen()) << row.key;
    EXPECT_EQ(panel.display->mode().width, absent.width);
    EXPECT_EQ(panel.display->mode().height, absent.height);
    const Surface surface = panel.display->acquire();
    fill_rect(surface, {0, 0, surface.width, surface.height}, {1, 2, 3});
    const Clock::time_point start = Clock::now();
    constexpr int kFrames = 6;
    for (int i = 0; i < kFrames; ++i) panel.display->present();
    EXPECT_GE(Clock::now() - start, (kFrames - 2) * milliseconds{16}) << "it must not spin";
    EXPECT_EQ(read_pixel(panel.display->shown(), 7, 5), (Rgb8{1, 2, 3}));
  }
}

TEST(Backends, ABadModeIsRefusedAtOnce) {
  for (const DisplayBackend& row : display_backends()) {
    if (row.key != "drm") continue;
    DisplayRequest bad = request();
    bad.options.mode = "1080p";
    EXPECT_NE(error_of([&] { return open_display("drm", bad); }).find("1920x1080@60"), std::string::npos);
  }
}

TEST(Backends, UnknownKeysAreRefusedWithTheNearest) {
  EXPECT_EQ(error_of([] { return open_display("headles", request()); }),
            "this build has no display 'headles'; did you mean 'headless'?");
  const Panel panel = open_display("headless", request());
  EXPECT_EQ(error_of([&] { return open_buttons("scrip", panel, {.buttons = kBox}); }),
            "this build has no buttons 'scrip'; did you mean 'script'?");
}

TEST(Backends, AbsentSourcesAreRefused) {
  const Panel panel = open_display("headless", request());
  EXPECT_EQ(
      error_of([&] { return open_buttons("script", panel, {.buttons = kBox}); }),
      "buttons 'script' need a script file and a synthetic clock; supply that or leave them out of the list");
  for (const ButtonsBackend& row : buttons_backends()) {
    EXPECT_EQ(row.open(panel, {.buttons = kBox}) == nullptr, !row.needs.empty()) << row.key;
  }
}

TEST(Backends, AScriptIsReadAndSeveralSourcesAreMerged) {
  std::string path = testing::TempDir() + "vitrine_backends_XXXXXX";
  const int file = mkstemp(path.data());
  ASSERT_NE(file, -1);
  std::ofstream(path) << "0 tap scene\n1 tap quit\n";
  const Panel panel = open_display("headless", request());
  SyntheticClock clock;
  const ButtonsRequest scripted{.buttons = kBox, .script = path, .clock = &clock};
  EXPECT_EQ(open_buttons("auto", panel, scripted)->poll(milliseconds{0}).size(), 1U);

  const auto twice = open_buttons("script,script", panel, scripted);
  EXPECT_EQ(twice->poll(milliseconds{0}).size(), 2U);
  clock.advance(std::chrono::seconds{2});
  const auto events = twice->poll(milliseconds{100});
  ASSERT_EQ(events.size(), 6U);
  for (std::size_t i = 1; i < events.size(); ++i) EXPECT_LE(events[i - 1].time, events[i].time);

  std::ofstream(path) << "0 tap nothing\n";
  EXPECT_THROW(static_cast<void>(open_buttons("auto", panel, scripted)), ScriptError);
  std::remove(path.c_str());
}

}  // namespace
}  // namespace vitrine
