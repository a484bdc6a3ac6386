// The window: real SDL events become button events, the panel follows the window's size, and what the
// renderer shows is the frame, byte for byte. Runs on the desktop session when there is one, else on SDL's
// dummy driver.
#include "sdl_window.h"

#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <SDL.h>
#include <gtest/gtest.h>

#include "backends.h"
#include "clocks.h"
#include "headless_display.h"

// Leaks that are not ours: libdbus, within SDL, when no session bus answers.
extern "C" const char* __lsan_default_suppressions() { return "leak:libdbus\n"; }

namespace vitrine {
namespace {

using std::chrono::milliseconds;

const std::vector<ButtonSpec> kBox = {
    {"scene", "Scene", "S"}, {"scene", "", "Right"}, {"mode", "Mode", "M"}, {"quit", "", "Escape"}};
constexpr int kWidth = 320;
constexpr int kHeight = 200;

/// A test picture: another colour in every pixel.
void draw_pattern(const Surface& surface, int seed) {
  std::vector<std::uint8_t> row(static_cast<std::size_t>(surface.width) * 3);
  for (int y = 0; y < surface.height; ++y) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      row[i] = static_cast<std::uint8_t>(static_cast<int>(i) * 13 + y * 29 + seed);
    }
    write_rgb_row(surface, 0, y, row);
  }
}

class SdlWindowTest : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) {
      setenv("SDL_VIDEODRIVER", "dummy", 0);
    }
    SDL_SetHint(SDL_HINT_RENDER_DRIVER, "software");  // its pixels can be read back after a present
    SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) GTEST_SKIP() << "no video driver: " << SDL_GetError();
    window_ = std::make_unique<SdlWindow>(kWidth, kHeight, "vitrine test", kBox, clock_);
    for (Uint32 id = 1; id < 1000 && sdl_ == nullptr; ++id) sdl_ = SDL_GetWindowFromID(id);
    ASSERT_NE(sdl_, nullptr);
    window_->poll(milliseconds{50});  // what the session has to say about a new window
  }

  void TearDown() override {
    window_.reset();
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
  }

  static void push_key(SDL_Keycode key, bool down, bool repeat = false) {
    SDL_Event event{};
    event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
    event.key.state = down ? SDL_PRESSED : SDL_RELEASED;
    event.key.repeat = repeat ? 1 : 0;
    event.key.keysym.sym = key;
    event.key.keysym.scancode = SDL_GetScancodeFromKey(key);
    ASSERT_EQ(SDL_PushEvent(&event), 1);
  }

  static void push_mouse(int x, int y, bool down, Uint32 which = 0) {
    SDL_Event event{};
    event.type = down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
    event.button.button = SDL_BUTTON_LEFT;
    event.button.which = which;
    event.button.x = x;
    event.button.y = y;
    ASSERT_EQ(SDL_PushEvent(&event), 1);
  }

  void push_finger(int x, int y, bool down, SDL_FingerID finger) const {
    int width = 0;
    int height = 0;
    SDL_GetWindowSize(sdl_, &width, &height);
    SDL_Event event{};
    event.type = down ? SDL_FINGERDOWN : SDL_FINGERUP;
    event.tfinger.touchId = 7;
    event.tfinger.fingerId = finger;
    event.tfinger.x = (static_cast<float>(x) + 0.5F) / static_cast<float>(width);
    event.tfinger.y = (static_cast<float>(y) + 0.5F) / static_cast<float>(height);
    ASSERT_EQ(SDL_PushEvent(&event), 1);
  }

  /// The middle of the n-th on-screen button, in the window.
  static std::pair<int, int> middle(std::size_t n) {
    const PixelRect rect = ButtonStrip(kBox).rect(kWidth, n);
    return {rect.x + rect.width / 2, kHeight + rect.y + rect.height / 2};
  }

  /// "scene+ scene-" for a press and a release.
  std::string polled(milliseconds timeout = milliseconds{0}) {
    std::string text;
    for (const ButtonEvent& event : window_->poll(timeout)) {
      text += (text.empty() ? "" : " ") + event.button + (event.edge == Edge::kPress ? "+" : "-");
    }
    return text;
  }

  /// The window's pixels as the renderer shows them.
  [[nodiscard]] SurfaceMemory screenshot() const {
    int width = 0;
    int height = 0;
    SDL_GetWindowSize(sdl_, &width, &height);
    SurfaceMemory picture(width, height, PixelFormat::kXrgb8888);
    EXPECT_EQ(
        SDL_RenderReadPixels(SDL_GetRenderer(sdl_), nullptr, SDL_PIXELFORMAT_XRGB8888,
                             picture.surface().pixels, static_cast<int>(picture.surface().stride_bytes)),
        0)
        << SDL_GetError();
    return picture;
  }

  static void expect_panel(const Surface& screen, const Surface& frame) {
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        ASSERT_EQ(read_pixel(screen, x, y), read_pixel(frame, x, y)) << x << "," << y;
      }
    }
  }

  SystemClock clock_;
  std::unique_ptr<SdlWindow> window_;
  SDL_Window* sdl_ = nullptr;
};

TEST_F(SdlWindowTest, KeysPressAndReleaseTheirButtons) {
  push_key(SDLK_m, true);
  push_key(SDLK_m, true, true);  // a repeat
  push_key(SDLK_x, true);        // no button's key
  push_key(SDLK_x, false);
  EXPECT_EQ(polled(), "mode+");
  push_key(SDLK_m, false);
  EXPECT_EQ(polled(), "mode-");
  push_key(SDLK_RIGHT, true);
  push_key(SDLK_RIGHT, false);
  EXPECT_EQ(polled(), "scene+ scene-") << "an alternative key";
  EXPECT_EQ(polled(), "");
}

TEST_F(SdlWindowTest, AButtonHeldTwiceIsPressedOnce) {
  push_key(SDLK_s, true);
  push_key(SDLK_RIGHT, true);
  push_key(SDLK_s, false);
  EXPECT_EQ(polled(), "scene+");
  push_key(SDLK_RIGHT, false);
  EXPECT_EQ(polled(), "scene-");
}

TEST_F(SdlWindowTest, ClicksAndTouchesPressOnScreenButtons) {
  const auto [x, y] = middle(1);
  push_mouse(x, y, true);
  EXPECT_EQ(polled(), "mode+");
  push_mouse(5, 5, false);
  EXPECT_EQ(polled(), "mode-") << "a release counts wherever the pointer went";
  push_mouse(5, 5, true);
  push_mouse(5, 5, false);
  EXPECT_EQ(polled(), "") << "the picture is no button";

  push_finger(x, y, true, 1);
  push_mouse(x, y, true, SDL_TOUCH_MOUSEID);  // SDL's copy of the same touch
  push_finger(middle(0).first, middle(0).second, true, 2);
  push_finger(x, y, false, 1);
  push_mouse(x, y, false, SDL_TOUCH_MOUSEID);
  push_finger(x, y, false, 2);
  EXPECT_EQ(polled(), "mode+ scene+ mode- scene-");
}

TEST_F(SdlWindowTest, ClosingPressesQuit) {
  SDL_Event event{};
  event.type = SDL_QUIT;
  ASSERT_EQ(SDL_PushEvent(&event), 1);
  EXPECT_EQ(polled(), "quit+ quit-");
}

TEST_F(SdlWindowTest, EventsCarryTheTimeTheyHappened) {
  const Clock::time_point before = Clock::now();
  push_key(SDLK_m, true);
  const Clock::time_point after = Clock::now();
  SDL_Delay(80);
  push_key(SDLK_m, false);
  const auto events = window_->poll(milliseconds{0});
  ASSERT_EQ(events.size(), 2U);
  EXPECT_GE(events[0].time, before - milliseconds{2});  // SDL counts whole milliseconds
  EXPECT_LE(events[0].time, after + milliseconds{40}) << "not the time of the poll";
  EXPECT_GE(events[1].time - events[0].time, milliseconds{70});
}

TEST_F(SdlWindowTest, PollWaitsForTheFirstEventOnly) {
  const Clock::time_point start = Clock::now();
  EXPECT_EQ(polled(milliseconds{60}), "");
  EXPECT_GE(Clock::now() - start, milliseconds{60});
  push_key(SDLK_m, true);
  EXPECT_EQ(polled(std::chrono::seconds{20}), "mode+");
  EXPECT_LT(Clock::now() - start, std::chrono::seconds{10});
}

TEST_F(SdlWindowTest, PresentCollectsEventsForTheNextPoll) {
  push_key(SDLK_m, true);
  window_->acquire();
  window_->present();
  SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
  EXPECT_EQ(polled(), "mode+");
}

TEST_F(SdlWindowTest, TheScreenIsTheHeadlessFrameByteForByte) {
  HeadlessDisplay headless(kWidth, kHeight);
  ASSERT_EQ(window_->mode().width, kWidth);
  ASSERT_EQ(window_->mode().height, kHeight);
  ASSERT_EQ(window_->mode().format, headless.mode().format);
  for (const int seed : {1, 90}) {
    for (Display* display : {static_cast<Display*>(&headless), static_cast<Display*>(window_.get())}) {
      draw_pattern(display->acquire(), seed);
      display->present();
    }
    const SurfaceMemory screen = screenshot();
    for (int y = 0; y < kHeight; ++y) {
      const auto row = static_cast<std::size_t>(y);
      const std::byte* shown = screen.surface().pixels + row * screen.surface().stride_bytes;
      const std::byte* frame = headless.shown().pixels + row * headless.shown().stride_bytes;
      ASSERT_EQ(std::memcmp(shown, frame, kWidth * 4), 0) << "row " << y;
    }
    expect_panel(window_->shown(), headless.shown());
  }
}

TEST_F(SdlWindowTest, APressIsSeenOnTheScreenAndAnExposedWindowIsDrawnAgain) {
  draw_pattern(window_->acquire(), 3);
  window_->present();
  const auto [x, y] = middle(1);
  const Rgb8 idle = read_pixel(screenshot().surface(), x - 30, y - 20);
  draw_pattern(window_->acquire(), 77);  // the next frame, not yet presented
  push_key(SDLK_m, true);
  EXPECT_EQ(polled(), "mode+");
  EXPECT_NE(read_pixel(screenshot().surface(), x - 30, y - 20), idle);
  push_key(SDLK_m, false);
  EXPECT_EQ(polled(), "mode-");
  EXPECT_EQ(read_pixel(screenshot().surface(), x - 30, y - 20), idle);

  SDL_SetRenderDrawColor(SDL_GetRenderer(sdl_), 255, 0, 255, 255);
  SDL_RenderClear(SDL_GetRenderer(sdl_));
  SDL_Event event{};
  event.type = SDL_WINDOWEVENT;
  event.window.windowID = SDL_GetWindowID(sdl_);
  event.window.event = SDL_WINDOWEVENT_EXPOSED;
  ASSERT_EQ(SDL_PushEvent(&event), 1);
  EXPECT_EQ(polled(), "");
  HeadlessDisplay last(kWidth, kHeight);
  draw_pattern(last.acquire(), 3);
  expect_panel(screenshot().surface(), last.shown());
}

TEST_F(SdlWindowTest, TheModeFollowsTheWindowsSize) {
  const Surface drawn_at_old_size = window_->acquire();
  const int strip = ButtonStrip(kBox).height(450);
  SDL_SetWindowSize(sdl_, 450, 300 + strip);
  const Clock::time_point deadline = Clock::now() + std::chrono::seconds{5};
  while (window_->mode().width != 450 && Clock::now() < deadline) window_->poll(milliseconds{10});
  ASSERT_EQ(window_->mode().width, 450);
  ASSERT_EQ(window_->mode().height, 300);

  draw_pattern(drawn_at_old_size, 5);  // a frame that was under way is shown, stretched
  window_->present();
  EXPECT_EQ(screenshot().surface().width, 450);

  const Surface surface = window_->acquire();
  EXPECT_EQ(surface.width, 450);
  EXPECT_EQ(surface.height, 300);
  draw_pattern(surface, 6);
  window_->present();
  expect_panel(screenshot().surface(), window_->shown());

  SDL_SetWindowSize(sdl_, 1, 1);
  for (int i = 0; i < 20; ++i) window_->poll(milliseconds{5});
  EXPECT_GE(window_->mode().width, 1);
  EXPECT_GE(window_->mode().height, 1);
  draw_pattern(window_->acquire(), 7);
  window_->present();
}

TEST_F(SdlWindowTest, UnknownKeyNamesAreRefused) {
  const std::vector<ButtonSpec> bad = {{"scene", "Scene", "Zorro"}};
  EXPECT_THROW(SdlWindow(64, 64, "bad", bad, clock_), std::runtime_error);
  EXPECT_THROW(
      static_cast<void>(open_display("auto", {.width = 64, .height = 64, .title = "bad", .buttons = bad})),
      std::runtime_error)
      << "a mistake in the buttons is no reason to fall back to memory";
}

TEST_F(SdlWindowTest, TheTableOpensAWindowWithItsButtons) {
  window_.reset();
  const Panel panel =
      open_display("auto", {.width = kWidth, .height = kHeight, .title = "test", .buttons = kBox});
  ASSERT_EQ(panel.backend, "sdl") << panel.notice;
  const auto buttons = open_buttons("sdl", panel, {.buttons = kBox});
  push_key(SDLK_s, true);
  EXPECT_EQ(buttons->poll(milliseconds{0}).size(), 1U);
}

// The last one, since it takes the desktop away.
TEST(SdlWindow, AutoFallsBackToMemoryWhenTheDesktopCannotBeReached) {
  for (const char* session : {"WAYLAND_DISPLAY", "SDL_VIDEODRIVER"}) unsetenv(session);
  setenv("DISPLAY", ":4711", 1);
  const Panel panel =
      open_display("auto", {.width = kWidth, .height = kHeight, .title = "test", .buttons = kBox});
  EXPECT_EQ(panel.backend, "headless");
  EXPECT_NE(panel.notice.find("sdl: SDL cannot use this desktop: "), std::string::npos) << panel.notice;
}

}  // namespace
}  // namespace vitrine
