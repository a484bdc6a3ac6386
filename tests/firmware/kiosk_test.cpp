// The loop with a display and buttons that tell the test what happens; the logic of time, not its speed, is
// tested.
#include "kiosk.h"

#include <functional>
#include <map>
#include <stdexcept>

#include <gtest/gtest.h>

#include "film/image_files.h"
#include "firmware/fake_scene.h"
#include "firmware/temporary_folder.h"
#include "surface.h"

namespace vitrine {
namespace {

class WatchedDisplay final : public Display {
 public:
  [[nodiscard]] DisplayMode mode() const override { return {size.width, size.height}; }
  Surface acquire() override {
    memory_ = SurfaceMemory(size.width, size.height, PixelFormat::kXrgb8888);
    return memory_.surface();
  }
  void present() override { on_present(); }
  [[nodiscard]] Surface shown() const override { return memory_.surface(); }

  PictureSize size{64, 48};
  std::function<void()> on_present = [] {};

 private:
  SurfaceMemory memory_{1, 1, PixelFormat::kXrgb8888};
};

class TestButtons final : public Buttons {
 public:
  std::vector<ButtonEvent> poll(std::chrono::milliseconds) override {
    std::vector<ButtonEvent> events;
    for (const std::string& name : next_press()) {
      events.push_back({name, Edge::kPress, Clock::now()});
      events.push_back({name, Edge::kRelease, Clock::now()});
    }
    return events;
  }

  std::function<std::vector<std::string>()> next_press = [] { return std::vector<std::string>{}; };
};

class KioskTest : public testing::Test {
 protected:
  [[nodiscard]] KioskSettings settings() const {
    KioskSettings settings;
    settings.exhibit.scenes = {named_scene("first"), named_scene("second"), named_scene("third")};
    settings.exhibit.mode = &modes()[0];
    settings.screenshot_folder = folder_.path();
    settings.lecture = {{.section = "One",
                         .caption = "First.",
                         .scene = named_scene("second"),
                         .techniques = {parse_technique("nee shadow-rays=16")}},
                        {.section = "Two",
                         .caption = "Second.",
                         .scene = named_scene("unlisted"),
                         .techniques = parse_comparison("basic,mis"),
                         .fairness = Fairness::kEqualTime}};
    return settings;
  }
  [[nodiscard]] Rgb8 shown_corner() const {
    return read_pixel(display_.shown(), display_.size.width - 1, display_.size.height - 1);
  }

  TemporaryFolder folder_;
  FakeWorld world_;
  Workers workers_{2};
  WatchedDisplay display_;
  TestButtons buttons_;
  SystemClock system_;
  SyntheticClock synthetic_;
  std::atomic<bool> stop_{false};
};

TEST_F(KioskTest, APressInMidPassIsAnsweredBeforeTheWorkersEvenNotice) {
  world_.endless = true;
  world_.deaf = true;
  Kiosk kiosk(display_, buttons_, system_, nullptr, workers_, fake_loader(world_), settings());
  bool pressed = false;
  buttons_.next_press = [&]() -> std::vector<std::string> {
    if (pressed || world_.tracing == 0) return {};
    pressed = true;
    return {"mode"};
  };
  bool answered = false;
  display_.on_present = [&] {
    if (!pressed) return;
    EXPECT_EQ(kiosk.hud().sides[0].mode, modes()[1].label);
    if (!answered) {
      EXPECT_GT(world_.tracing, 0);
      EXPECT_EQ(kiosk.hud().sides[0].samples_per_pixel, 0U);
      answered = true;
      world_.endless = false;
      world_.deaf = false;
    }
    stop_ = kiosk.hud().sides[0].samples_per_pixel > 0;
  };
  const KioskReport report = kiosk.run(stop_);
  EXPECT_GT(world_.cancelled, 0);
  EXPECT_EQ(report.presses, 1U);
  EXPECT_GT(report.slowest_press_ms, 0.0);
}

TEST_F(KioskTest, TheOldPictureStaysUnderTheNewLabel) {
  Kiosk kiosk(display_, buttons_, system_, nullptr, workers_, fake_loader(world_), settings());
  bool pressed = false;
  buttons_.next_press = [&]() -> std::vector<std::string> {
    if (pressed || kiosk.hud().sides[0].samples_per_pixel == 0) return {};
    pressed = true;
    return {"mode"};
  };
  bool answered = false;
  display_.on_present = [&] {
    if (!pressed) return;
    const Rgb8 corner = shown_corner();
    if (!answered) {
      EXPECT_EQ(corner.g, fake_grey(modes()[0]) / 2) << "dimmed";
      answered = true;
    } else if (kiosk.hud().sides[0].samples_per_pixel > 0) {
      EXPECT_EQ(corner.g, fake_grey(modes()[1]));
      stop_ = true;
    }
  };
  kiosk.run(stop_);
}

TEST_F(KioskTest, SaysLoadingWhileASceneLoads) {
  std::atomic<bool> go{false};
  const LoadScene load = [&](const PlaylistScene& scene, Numbers) {
    while (scene.name == "second" && !go) std::this_thread::yield();
    return fake_scene(world_);
  };
  Kiosk kiosk(display_, buttons_, system_, nullptr, workers_, load, settings());
  bool pressed = false;
  buttons_.next_press = [&]() -> std::vector<std::string> {
    if (pressed || kiosk.hud().sides[0].samples_per_pixel == 0) return {};
    pressed = true;
    return {"scene"};
  };
  bool said = false;
  display_.on_present = [&] {
    if (!pressed) return;
    EXPECT_EQ(kiosk.hud().title, "The second");
    said = said || kiosk.hud().loading;
    if (kiosk.hud().loading) go = true;
    stop_ = !kiosk.hud().loading && kiosk.hud().sides[0].samples_per_pixel > 0;
  };
  kiosk.run(stop_);
  EXPECT_TRUE(said);
}

TEST_F(KioskTest, ABrokenSceneIsACardAndTheNextPressGoesOn) {
  const LoadScene load = [&](const PlaylistScene& scene, Numbers) -> std::shared_ptr<const LoadedScene> {
    if (scene.name == "first") throw std::runtime_error("first.gltf: broken; mend it");
    return fake_scene(world_);
  };
  Kiosk kiosk(display_, buttons_, system_, nullptr, workers_, load, settings());
  bool pressed = false;
  buttons_.next_press = [&]() -> std::vector<std::string> {
    if (pressed || kiosk.hud().error.empty()) return {};
    EXPECT_EQ(kiosk.hud().error, "first.gltf: broken; mend it");
    EXPECT_NE(shown_corner(), Rgb8{});
    pressed = true;
    return {"scene"};
  };
  display_.on_present = [&] { stop_ = pressed && kiosk.hud().sides[0].samples_per_pixel > 0; };
  kiosk.run(stop_);
  EXPECT_EQ(kiosk.hud().title, "The second");
  EXPECT_TRUE(kiosk.hud().error.empty());
}

TEST_F(KioskTest, FollowsTheDisplaysSize) {
  Kiosk kiosk(display_, buttons_, system_, nullptr, workers_, fake_loader(world_), settings());
  int resized_frames = 0;
  display_.on_present = [&] {
    if (resized_frames > 0 && ++resized_frames == 2) {
      EXPECT_LE(kiosk.hud().sides[0].samples_per_pixel, 1U) << "begun anew";
    }
    if (resized_frames > 0) {
      stop_ = kiosk.hud().sides[0].samples_per_pixel > 0 && shown_corner().g == fake_grey(modes()[0]);
    } else if (kiosk.hud().sides[0].samples_per_pixel > 1) {
      display_.size = {101, 67};
      resized_frames = 1;
    }
  };
  kiosk.run(stop_);
  EXPECT_EQ(display_.shown().width, 101);
}

TEST_F(KioskTest, EndsAfterItsFramesOrAtQuit) {
  KioskSettings three = settings();
  three.frames = 3;
  Kiosk counted(display_, buttons_, system_, nullptr, workers_, fake_loader(world_), three);
  EXPECT_EQ(counted.run(stop_).frames, 3U);

  Kiosk quitting(display_, buttons_, system_, nullptr, workers_, fake_loader(world_), settings());
  buttons_.next_press = [] { return std::vector<std::string>{"quit"}; };
  EXPECT_EQ(quitting.run(stop_).presses, 1U);
}

/// A stepped session: `presses` by frame, `check` after each frame.
class SteppedKioskTest : public KioskTest {
 protected:
  void run(std::uint64_t frames, const std::function<std::vector<std::string>(std::uint64_t)>& presses,
           const std::function<void(std::uint64_t, const HudState&)>& check) {
    KioskSettings stepped = settings();
    stepped.frames = frames;
    Kiosk kiosk(display_, buttons_, synthetic_, &synthetic_, workers_, fake_loader(world_), stepped);
    std::uint64_t frame = 0;
    buttons_.next_press = [&] { return presses(frame); };
    display_.on_present = [&] { check(frame++, kiosk.hud()); };
    kiosk.run(stop_);
    EXPECT_EQ(frame, frames);
  }
};

TEST_F(SteppedKioskTest, EachFrameIsASixtiethAndASample) {
  run(
      130, [](std::uint64_t) { return std::vector<std::string>{}; },
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
      10,
      [](std::uint64_t frame) {
        return frame == 3 || frame == 6 ? std::vector<std::string>{"pause"} : std::vector<std::string>{};
      },
      [](std::uint64_t frame, const HudState& hud) {
        EXPECT_EQ(hud.paused, frame >= 3 && frame < 6);
        EXPECT_EQ(hud.sides[0].samples_per_pixel, frame < 3 ? frame + 1 : frame < 6 ? 3 : frame - 2);
      });
}

TEST_F(SteppedKioskTest, AHiddenHudComesBackForTwoSecondsAfterAPress) {
  run(
      300,
      [](std::uint64_t frame) {
        if (frame == 0) return std::vector<std::string>{"hud"};
        if (frame == 150) return std::vector<std::string>{"mode"};
        return std::vector<std::string>{};
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
      [](std::uint64_t frame) -> std::vector<std::string> {
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
      3,
      [](std::uint64_t frame) {
        return frame == 2 ? std::vector<std::string>{"screenshot"} : std::vector<std::string>{};
      },
      [](std::uint64_t frame, const HudState& hud) {
        EXPECT_EQ(hud.notice, frame == 2 ? "saved vitrine-first-basic-2spp.png" : "");
      });
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "vitrine-first-basic-2spp.png"));
}

using Names = std::vector<std::string>;

/// The presses of a session: a button at each frame that has one.
std::function<Names(std::uint64_t)> presses_at(std::map<std::uint64_t, std::string> buttons) {
  return [buttons = std::move(buttons)](std::uint64_t frame) {
    const auto found = buttons.find(frame);
    return found == buttons.end() ? Names{} : Names{found->second};
  };
}

TEST_F(SteppedKioskTest, TheLectureGoesFromStopToStopUntilAnotherButtonLeavesIt) {
  const std::map<std::uint64_t, std::string> presses{{1, "lecture"}, {3, "pause"},    {4, "pause"},
                                                     {5, "lecture"}, {7, "lecture"},  {9, "lecture"},
                                                     {11, "mode"},   {13, "lecture"}, {15, "scene"}};
  run(17, presses_at(presses), [](std::uint64_t frame, const HudState& hud) {
    const auto expect = [&](const std::string& title, const std::string& caption, std::size_t sides) {
      EXPECT_EQ(hud.title, title) << frame;
      EXPECT_EQ(hud.caption, caption) << frame;
      EXPECT_EQ(hud.sides.size(), sides) << frame;
    };
    if (frame == 0) expect("The first", "", 1);
    if (frame >= 1 && frame < 5) expect("1/2 One", "First.", 1);  // the pause does not leave it
    if (frame == 2) {
      EXPECT_EQ(hud.sides[0].changes, "Shadow rays 16");
    }
    if (frame >= 5 && frame < 7) {
      expect("2/2 Two", "Second.", 2);
      EXPECT_EQ(hud.fairness, "equal time");
    }
    if (frame >= 7 && frame < 9) expect("1/2 One", "First.", 1);  // round again
    if (frame >= 9 && frame < 11) expect("2/2 Two", "Second.", 2);
    if (frame >= 11 && frame < 13) expect("The unlisted", "", 2);    // left by a change of the mode
    if (frame >= 13 && frame < 15) expect("2/2 Two", "Second.", 2);  // back to the stop that was left
    if (frame >= 15) expect("The third", "", 2);  // after the scene of the last stop that the playlist has
  });
}

TEST_F(KioskTest, WithoutALectureTheButtonSaysSo) {
  KioskSettings none = settings();
  none.lecture.clear();
  none.frames = 2;
  Kiosk kiosk(display_, buttons_, synthetic_, &synthetic_, workers_, fake_loader(world_), none);
  buttons_.next_press = [] { return Names{"lecture"}; };
  kiosk.run(stop_);
  EXPECT_NE(kiosk.hud().notice.find("--lecture"), std::string::npos);
  EXPECT_EQ(kiosk.hud().title, "The first");
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
  std::vector<std::string> said;
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

/// Twelve synthetic seconds with one press.
TEST_F(KioskTest, LeftAloneItShowsItselfAndBeginsAnew) {
  KioskSettings idle = settings();
  idle.frames = 60 * 12;
  idle.manners.idle = {.after = std::chrono::seconds(4), .every = std::chrono::seconds(2), .reset = {}};
  Kiosk kiosk(display_, buttons_, synthetic_, &synthetic_, workers_, fake_loader(world_), idle);
  std::uint64_t frame = 0;
  buttons_.next_press = [&] { return frame == 540 ? Names{"scene"} : Names{}; };
  std::vector<std::string> titles;
  display_.on_present = [&] {
    if (titles.empty() || titles.back() != kiosk.hud().title) titles.push_back(kiosk.hud().title);
    ++frame;
  };
  kiosk.run(stop_);
  EXPECT_EQ(titles, (Names{"The first", "1/2 One", "2/2 Two", "1/2 One", "The third"}));
}

TEST_F(KioskTest, ABlackHourShowsNothingAndTracesNothing) {
  KioskSettings dark = settings();
  dark.manners.dim = {{TimeOfDay(0), TimeOfDay(60), 0.0}};
  dark.manners.time_of_day = [] { return TimeOfDay(30); };
  dark.frames = 3;
  Kiosk kiosk(display_, buttons_, system_, nullptr, workers_, fake_loader(world_), dark);
  display_.on_present = [&] {
    EXPECT_EQ(read_pixel(display_.shown(), 5, 5), Rgb8{});
    EXPECT_EQ(kiosk.hud().sides[0].samples_per_pixel, 0U);
  };
  kiosk.run(stop_);
}

TEST_F(KioskTest, AComplaintIsACardOverThePictureUntilARefit) {
  KioskSettings wrong = settings();
  wrong.complaint = "list.toml: broken; mend it";
  wrong.frames = 6;
  std::uint64_t frame = 0;
  const KioskCare care{.supervisor = nullptr, .take_refit = [&]() -> std::optional<Refit> {
                         if (frame == 2) return Refit{.settings = {}, .notice = "still wrong"};
                         if (frame != 4) return std::nullopt;
                         KioskSettings right = settings();
                         right.exhibit.scenes.erase(right.exhibit.scenes.begin());
                         return Refit{.settings = right, .notice = "mended"};
                       }};
  Kiosk kiosk(display_, buttons_, synthetic_, &synthetic_, workers_, fake_loader(world_), wrong, care);
  display_.on_present = [&] {
    EXPECT_EQ(kiosk.hud().error, frame < 4 ? wrong.complaint : "") << frame;
    EXPECT_EQ(kiosk.hud().over_picture, frame < 4) << frame;
    EXPECT_EQ(kiosk.hud().notice, frame < 2 ? "" : frame < 4 ? "still wrong" : "mended") << frame;
    EXPECT_EQ(kiosk.hud().title, frame < 4 ? "The first" : "The second") << frame;
    ++frame;
  };
  kiosk.run(stop_);
}

// The answer to a press must not wait for either side's pass.
TEST_F(KioskTest, APressInMidPassOfAComparisonIsAnsweredBeforeTheWorkersEvenNotice) {
  for (const std::string button : {"compare", "mode", "scene", "lecture", "numbers", "shadow-rays"}) {
    KioskSettings compared = settings();
    compared.exhibit.compare = parse_comparison("basic,nee");
    Kiosk kiosk(display_, buttons_, system_, nullptr, workers_, fake_loader(world_), compared);
    bool pressed = false;
    bool answered = false;
    stop_ = false;
    buttons_.next_press = [&]() -> Names {
      if (pressed || world_.tracing == 0 || kiosk.hud().sides.back().samples_per_pixel == 0) {
        // Both sides have something to show: from now on no pass ends.
        world_.endless = kiosk.hud().sides.back().samples_per_pixel > 0 && !answered;
        world_.deaf = world_.endless.load();
        return {};
      }
      if (!world_.endless) {
        world_.endless = true;
        world_.deaf = true;
        return {};
      }
      pressed = true;
      return {button};
    };
    display_.on_present = [&] {
      if (!pressed) return;
      if (!answered) {
        EXPECT_GT(world_.tracing, 0) << button;
        answered = true;
        world_.endless = false;
        world_.deaf = false;
      }
      stop_ = kiosk.hud().sides.front().samples_per_pixel > 0;
    };
    EXPECT_EQ(kiosk.run(stop_).presses, 1U) << button;
    display_.on_present = [] {};
  }
}

}  // namespace
}  // namespace vitrine
