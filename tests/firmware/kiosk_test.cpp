// The live loop: a press is answered at once, whatever the workers and the loader do meanwhile.
#include <stdexcept>

#include <gtest/gtest.h>

#include "firmware/watched_kiosk.h"

namespace vitrine {
namespace {

TEST_F(KioskTest, APressInMidPassIsAnsweredBeforeTheWorkersEvenNotice) {
  world_.endless = true;
  world_.deaf = true;
  Kiosk kiosk(display_, buttons_, system_, nullptr, workers_, fake_loader(world_), settings());
  bool pressed = false;
  buttons_.next_press = [&]() -> Names {
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

TEST_F(KioskTest, TheOldPictureStaysUnderTheNewLabel) {
  Kiosk kiosk(display_, buttons_, system_, nullptr, workers_, fake_loader(world_), settings());
  bool pressed = false;
  buttons_.next_press = [&]() -> Names {
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
  buttons_.next_press = [&]() -> Names {
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
  buttons_.next_press = [&]() -> Names {
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
  buttons_.next_press = [] { return Names{"quit"}; };
  EXPECT_EQ(quitting.run(stop_).presses, 1U);
}

}  // namespace
}  // namespace vitrine
