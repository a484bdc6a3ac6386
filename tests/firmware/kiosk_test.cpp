// The loop with a display and buttons that tell the test what happens; the logic of time, not its speed, is
// tested.
#include "kiosk.h"

#include <functional>
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
      events.push_back({name, Edge::kPress, {}});
      events.push_back({name, Edge::kRelease, {}});
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
    EXPECT_EQ(kiosk.hud().mode, modes()[1].label);
    if (!answered) {
      EXPECT_GT(world_.tracing, 0);
      EXPECT_EQ(kiosk.hud().samples_per_pixel, 0U);
      answered = true;
      world_.endless = false;
      world_.deaf = false;
    }
    stop_ = kiosk.hud().samples_per_pixel > 0;
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
    if (pressed || kiosk.hud().samples_per_pixel == 0) return {};
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
    } else if (kiosk.hud().samples_per_pixel > 0) {
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
    if (pressed || kiosk.hud().samples_per_pixel == 0) return {};
    pressed = true;
    return {"scene"};
  };
  bool said = false;
  display_.on_present = [&] {
    if (!pressed) return;
    EXPECT_EQ(kiosk.hud().title, "The second");
    said = said || kiosk.hud().loading;
    if (kiosk.hud().loading) go = true;
    stop_ = !kiosk.hud().loading && kiosk.hud().samples_per_pixel > 0;
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
  display_.on_present = [&] { stop_ = pressed && kiosk.hud().samples_per_pixel > 0; };
  kiosk.run(stop_);
  EXPECT_EQ(kiosk.hud().title, "The second");
  EXPECT_TRUE(kiosk.hud().error.empty());
}

TEST_F(KioskTest, FollowsTheDisplaysSize) {
  Kiosk kiosk(display_, buttons_, system_, nullptr, workers_, fake_loader(world_), settings());
  int resized_frames = 0;
  display_.on_present = [&] {
    if (resized_frames > 0 && ++resized_frames == 2) {
      EXPECT_LE(kiosk.hud().samples_per_pixel, 1U) << "begun anew";
    }
    if (resized_frames > 0) {
      stop_ = kiosk.hud().samples_per_pixel > 0 && shown_corner().g == fake_grey(modes()[0]);
    } else if (kiosk.hud().samples_per_pixel > 1) {
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
        EXPECT_EQ(hud.samples_per_pixel, frame + 1);
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
        EXPECT_EQ(hud.samples_per_pixel, frame < 3 ? frame + 1 : frame < 6 ? 3 : frame - 2);
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

}  // namespace
}  // namespace vitrine
