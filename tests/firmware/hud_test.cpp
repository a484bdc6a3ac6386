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
  state.sides.front().mode = "Next event estimation";
  state.sides.front().samples_per_pixel = 12;
  state.sides.front().error = 0.0324;
  state.numbers = "fixed";
  state.frames_per_second = 59.94;
  state.rays_per_second = 4.07e6;
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
  EXPECT_EQ(lines, (std::vector<std::string>{"Cornell box", "Next event estimation", "12 spp · error 3.2 %",
                                             "fixed · 59.9 fps · 4.1 Mrays/s · 1:15"}));
}

TEST(Hud, WritesErrorsAndRatesInTwoDigitsThatCount) {
  EXPECT_EQ(percent(1.304), "130 %");
  EXPECT_EQ(percent(0.0996), "10 %");
  EXPECT_EQ(percent(0.0994), "9.9 %");
  EXPECT_EQ(percent(0.00996), "1.0 %");
  EXPECT_EQ(percent(0.0057), "0.57 %");
  HudState state = some_state();
  state.rays_per_second = 83'400.0;
  EXPECT_THAT(hud_lines(state), Contains(HasSubstr("83 krays/s")));
  state.rays_per_second = 0.0;
  EXPECT_THAT(hud_lines(state), Not(Contains(HasSubstr("rays/s"))));
  state.sides.front().error.reset();
  EXPECT_THAT(hud_lines(state), Not(Contains(HasSubstr("error"))));
}

TEST(Hud, EachOfTwoSidesHasALabelOfItsOwn) {
  HudState state = some_state();
  state.sides.push_back({.mode = "Basic path tracing",
                         .changes = "Sequence grid",
                         .bias = "it misses",
                         .samples_per_pixel = 7,
                         .error = 1.2});
  state.fairness = "equal time";
  EXPECT_EQ(hud_lines(state),
            (std::vector<std::string>{"Cornell box", "fixed · equal time · 59.9 fps · 4.1 Mrays/s · 1:15"}));
  EXPECT_EQ(side_lines(state.sides.back()),
            (std::vector<std::string>{"Basic path tracing", "Sequence grid", "biased: it misses",
                                      "7 spp · error 120 %"}));
  EXPECT_THAT(hud_text(state), Contains("Next event estimation"));
  EXPECT_THAT(hud_text(state), Contains("Basic path tracing"));
}

TEST(Hud, SideLabelsStayOnTheirSides) {
  const std::vector<HudSide> sides(2, some_state().sides.front());
  for (const double split : {0.0, 0.1, 0.5, 0.8, 1.0}) {
    SurfaceMemory memory(640, 400, PixelFormat::kXrgb8888);
    fill_rect(memory.surface(), {0, 0, 640, 400}, {128, 128, 128});
    draw_side_labels(memory.surface(), sides, split, 10);
    const int column = split_column(split, 640);
    int drawn[2] = {0, 0};
    for (int y = 0; y < 400; ++y) {
      for (int x = 0; x < 640; ++x)
        drawn[x < column ? 0 : 1] += read_pixel(memory.surface(), x, y) == Rgb8{128, 128, 128} ? 0 : 1;
    }
    EXPECT_EQ(drawn[0] > 0, split > 0.3) << split;
    EXPECT_EQ(drawn[1] > 0, split < 0.9) << split;
    for (int y = 0; y < 400; ++y) {
      for (int x = std::max(column - 4, 0); x < std::min(column + 4, 640); ++x)
        EXPECT_EQ(read_pixel(memory.surface(), x, y), (Rgb8{128, 128, 128})) << x;
    }
  }
}

TEST(Hud, SaysWhatIsOutOfTheOrdinary) {
  HudState state = some_state();
  state.sides.front().bias = "longer paths are missing";
  state.sides.front().changes = "Shadow rays 16";
  state.view = "Variance map";
  state.view_legend = "white is bad";
  state.exposure_stops = -1.5;
  state.paused = true;
  state.loading = true;
  state.notice = "saved x.png";
  const std::vector<std::string> lines = hud_lines(state);
  EXPECT_THAT(lines, Contains("biased: longer paths are missing"));
  EXPECT_THAT(lines, Contains("Shadow rays 16"));
  EXPECT_THAT(lines, Contains("Variance map: white is bad"));
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
      std::string(50, 'w') + " of a word.";
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
  other.sides.front().mode = "Basic path tracing etc.";
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
