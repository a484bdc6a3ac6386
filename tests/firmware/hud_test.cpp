#include "hud.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vitrine {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

HudState some_state() {
  HudState state;
  state.title = "Cornell box";
  state.mode = "Next event estimation";
  state.numbers = "fixed";
  state.samples_per_pixel = 12;
  state.frames_per_second = 59.94;
  state.seconds = 75.9;
  return state;
}

/// Pixels that differ from the plain grey they were filled with.
int drawn_pixels(const HudState& state, int width, int height, int from_row, int to_row) {
  const Rgb8 grey{128, 128, 128};
  SurfaceMemory memory(width, height, PixelFormat::kXrgb8888);
  fill_rect(memory.surface(), {0, 0, width, height}, grey);
  draw_hud(memory.surface(), state);
  int drawn = 0;
  for (int y = from_row; y < to_row; ++y) {
    for (int x = 0; x < width; ++x) drawn += read_pixel(memory.surface(), x, y) == grey ? 0 : 1;
  }
  return drawn;
}

TEST(Hud, SaysWhatIsShown) {
  const std::vector<std::string> lines = hud_lines(some_state());
  EXPECT_EQ(lines, (std::vector<std::string>{"Cornell box", "Next event estimation",
                                             "fixed · 12 spp · 59.9 fps · 1:15"}));
}

TEST(Hud, SaysWhatIsOutOfTheOrdinary) {
  HudState state = some_state();
  state.unbiased = false;
  state.exposure_stops = -1.5;
  state.paused = true;
  state.loading = true;
  state.notice = "saved x.png";
  const std::vector<std::string> lines = hud_lines(state);
  EXPECT_THAT(lines, Contains("Next event estimation (biased)"));
  EXPECT_THAT(lines, Contains("exposure -1.50 EV"));
  EXPECT_THAT(lines, Contains("paused"));
  EXPECT_THAT(lines, Contains(HasSubstr("loading")));
  EXPECT_THAT(lines, Contains("saved x.png"));
}

TEST(Hud, HidesButForErrors) {
  HudState state = some_state();
  state.visible = false;
  EXPECT_EQ(drawn_pixels(state, 320, 240, 0, 240), 0);
  state.error = "a.gltf: cannot be read; name another file";
  EXPECT_EQ(drawn_pixels(state, 320, 240, 0, 240), 320 * 240);
}

TEST(Hud, FitsSmallPanelsAndLeavesThePictureVisible) {
  HudState state = some_state();
  state.caption =
      std::string("A caption that is a good deal longer than one line of the smallest panel, with a ") +
      std::string(80, 'w') + " of a word.";
  for (const auto& [width, height] : {std::pair{320, 240}, {240, 320}, {800, 480}, {1920, 1080}}) {
    const int top = drawn_pixels(state, width, height, 0, height / 2);
    const int bottom = drawn_pixels(state, width, height, height / 2, height);
    EXPECT_GT(top, width * height / 100) << width;
    EXPECT_GT(bottom, width * height / 100) << width;
    EXPECT_LT(top + bottom, width * height / 2) << width;
  }
  // Whatever the panel, nothing is drawn outside it (the sanitizers would tell).
  for (const int side : {1, 7, 40}) drawn_pixels(state, side, side, 0, side);
}

TEST(Hud, TextChangesPixels) {
  HudState other = some_state();
  other.mode = "Basic path tracing etc.";
  const auto pixels = [](const HudState& state) {
    SurfaceMemory memory(320, 240, PixelFormat::kRgb888);
    draw_hud(memory.surface(), state);
    std::vector<int> greens;
    for (int y = 0; y < 240; ++y) {
      for (int x = 0; x < 320; ++x) greens.push_back(read_pixel(memory.surface(), x, y).g);
    }
    return greens;
  };
  EXPECT_EQ(pixels(some_state()), pixels(some_state()));
  EXPECT_NE(pixels(some_state()), pixels(other));
  EXPECT_THAT(pixels(some_state()), Contains(255));
}

}  // namespace
}  // namespace vitrine
