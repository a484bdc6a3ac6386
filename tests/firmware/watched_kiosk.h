// A kiosk on a display and buttons that tell the test what happens, with scenes that cost nothing: the logic
// of time, not its speed, is tested.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "firmware/fake_scene.h"
#include "firmware/temporary_folder.h"
#include "kiosk.h"
#include "surface.h"

namespace vitrine {

using Names = std::vector<std::string>;

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

  [[nodiscard]] std::string notice() const override { return missing; }

  std::function<Names()> next_press = [] { return Names{}; };
  std::string missing{};
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

/// A stepped session: `presses` by frame, `check` after each frame.
class SteppedKioskTest : public KioskTest {
 protected:
  void run(std::uint64_t frames, const std::function<Names(std::uint64_t)>& presses,
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

/// The presses of a session: a button at each frame that has one.
inline std::function<Names(std::uint64_t)> presses_at(std::map<std::uint64_t, std::string> buttons) {
  return [buttons = std::move(buttons)](std::uint64_t frame) {
    const auto found = buttons.find(frame);
    return found == buttons.end() ? Names{} : Names{found->second};
  };
}

}  // namespace vitrine
