// What the buttons of a stepped session change in the labels and the picture, frame by frame.
#include <filesystem>

#include <gtest/gtest.h>

#include "firmware/watched_kiosk.h"

namespace vitrine {
namespace {

TEST_F(SteppedKioskTest, EachFrameIsASixtiethAndASample) {
  run(
      130, [](std::uint64_t) { return Names{}; },
      [](std::uint64_t frame, const HudState& hud) {
        EXPECT_EQ(hud.sides[0].samples_per_pixel, frame + 1);
        EXPECT_NEAR(hud.seconds, static_cast<double>(frame) / 60.0, 1e-6);
        if (frame > 31) {
          EXPECT_NEAR(hud.frames_per_second, 60.0, 0.01);
        }
      });
}

TEST_F(SteppedKioskTest, PauseStopsSamplesAndTime) {
  run(
      10, [](std::uint64_t frame) { return frame == 3 || frame == 6 ? Names{"pause"} : Names{}; },
      [](std::uint64_t frame, const HudState& hud) {
        EXPECT_EQ(hud.paused, frame >= 3 && frame < 6);
        EXPECT_EQ(hud.sides[0].samples_per_pixel, frame < 3 ? frame + 1 : frame < 6 ? 3 : frame - 2);
      });
}

TEST_F(SteppedKioskTest, AHiddenHudComesBackForTwoSecondsAfterAPress) {
  run(
      300,
      [](std::uint64_t frame) {
        if (frame == 0) return Names{"hud"};
        if (frame == 150) return Names{"mode"};
        return Names{};
      },
      [](std::uint64_t frame, const HudState& hud) {
        if (frame < 119 || (frame >= 150 && frame < 269)) {
          EXPECT_TRUE(hud.visible) << frame;
        }
        if ((frame > 121 && frame < 150) || frame > 271) {
          EXPECT_FALSE(hud.visible) << frame;
        }
      });
}

TEST_F(SteppedKioskTest, ExposureAndNumbersShowInTheLabels) {
  run(
      4,
      [](std::uint64_t frame) -> Names {
        if (frame == 1) return {"exposure-up", "exposure-up", "exposure-down", "numbers"};
        if (frame == 3) return {"exposure-auto"};
        return {};
      },
      [](std::uint64_t frame, const HudState& hud) {
        EXPECT_EQ(hud.exposure_stops.has_value(), frame == 1 || frame == 2);
        if (hud.exposure_stops) {
          EXPECT_EQ(*hud.exposure_stops, 1.5);
        }
        EXPECT_EQ(hud.numbers, frame == 0 ? "float" : "fixed");
      });
}

TEST_F(SteppedKioskTest, SavesWhatIsShown) {
  run(
      3, [](std::uint64_t frame) { return frame == 2 ? Names{"screenshot"} : Names{}; },
      [](std::uint64_t frame, const HudState& hud) {
        EXPECT_EQ(hud.notice, frame == 2 ? "saved vitrine-first-basic-2spp.png" : "");
      });
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "vitrine-first-basic-2spp.png"));
}

TEST_F(SteppedKioskTest, TheSplitMovesOverPicturesThatGoOn) {
  display_.size = {320, 200};
  const auto shown = [&](int x) { return read_pixel(display_.shown(), x, 199).g; };
  std::map<std::uint64_t, std::string> presses{{1, "compare"}};
  for (std::uint64_t frame = 4; frame < 24; ++frame) presses[frame] = "split-left";
  for (std::uint64_t frame = 24; frame < 60; ++frame) presses[frame] = "split-right";
  run(60, presses_at(presses), [&](std::uint64_t frame, const HudState& hud) {
    if (frame < 3) return;
    const auto column = static_cast<int>(hud.split * 320.0);
    if (frame < 4) {
      EXPECT_EQ(column, 160);
    }
    const std::uint8_t left = fake_grey(*find_mode("basic"));
    const std::uint8_t right = fake_grey(*find_mode("nee"));
    if (column > 3) {
      EXPECT_EQ(shown(column - 3), left) << frame;
    }
    if (column < 317) {
      EXPECT_EQ(shown(column + 3), right) << frame;
    }
    EXPECT_EQ(hud.split, frame < 4 ? 0.5 : hud.split);
    if (frame == 20) {
      EXPECT_EQ(hud.split, 0.0) << "it stops at the edge";
    }
    if (frame == 59) {
      EXPECT_EQ(hud.split, 1.0);
    }
    // Moving it began nothing anew.
    EXPECT_GE(hud.sides[0].samples_per_pixel + hud.sides[1].samples_per_pixel, frame);
  });
}

TEST_F(SteppedKioskTest, AParameterHasAButtonAndTheLabelNamesIt) {
  std::map<std::uint64_t, std::string> presses;
  std::uint64_t frame = 1;
  for (const Parameter& parameter : parameters()) presses[frame++] = parameter.name;
  Names said;
  run(frame + 1, presses_at(presses),
      [&](std::uint64_t, const HudState& hud) { said.push_back(hud.sides[0].changes); });
  EXPECT_EQ(said[0], "");
  Technique expected = technique_of(modes()[0]);
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    expected = turned(expected, parameters()[i]);
    EXPECT_EQ(said[i + 1], describe_changes(expected)) << parameters()[i].name;
  }
  EXPECT_FALSE(said.back().empty());
}

TEST_F(SteppedKioskTest, TheLabelsTellErrorAndRays) {
  run(
      80, [](std::uint64_t) { return Names{}; },
      [](std::uint64_t frame, const HudState& hud) {
        EXPECT_EQ(hud.sides[0].error.has_value(), frame > 0) << "a single sample tells no error";
        if (frame > 40) {
          EXPECT_NEAR(hud.rays_per_second, 64.0 * 48.0 * 60.0, 64.0 * 48.0 * 2.1);
        }
      });
}

TEST_F(SteppedKioskTest, TheViewIsNamedWithItsLegend) {
  run(4, presses_at({{1, "view"}, {3, "view"}}), [](std::uint64_t frame, const HudState& hud) {
    EXPECT_EQ(hud.view.empty(), frame == 0 || frame == 3);
    EXPECT_EQ(hud.view_legend.empty(), frame == 0 || frame == 3);
  });
}

}  // namespace
}  // namespace vitrine
