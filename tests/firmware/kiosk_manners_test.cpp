// What a kiosk does beyond a press and its picture: the lecture, the idle tour, dark hours, complaints, and
// the waiting for a button that is held.
#include <gtest/gtest.h>

#include "firmware/watched_kiosk.h"

namespace vitrine {
namespace {

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

/// Twelve synthetic seconds with one press.
TEST_F(KioskTest, LeftAloneItShowsItselfAndBeginsAnew) {
  KioskSettings idle = settings();
  idle.frames = 60 * 12;
  idle.manners.idle = {.after = std::chrono::seconds(4), .every = std::chrono::seconds(2), .reset = {}};
  Kiosk kiosk(display_, buttons_, synthetic_, &synthetic_, workers_, fake_loader(world_), idle);
  std::uint64_t frame = 0;
  buttons_.next_press = [&] { return frame == 540 ? Names{"scene"} : Names{}; };
  Names titles;
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

/// Holds the button "mode" down from the first time it is asked while the kiosk has nothing to do. Its time
/// is that of the waiting alone.
class HeldButton final : public Buttons {
 public:
  explicit HeldButton(SyntheticClock& clock) : clock_(clock) {}

  std::vector<ButtonEvent> poll(std::chrono::milliseconds timeout) override {
    clock_.advance(timeout);
    if (timeout.count() == 0 || std::exchange(held_, true)) return {};
    pressed = clock_.now();
    return {{"mode", Edge::kPress, pressed}};
  }

  Clock::time_point pressed{};

 private:
  SyntheticClock& clock_;
  bool held_ = false;
};

TEST_F(KioskTest, IdleItWakesAtTheDeadlineOfAHeldButton) {
  constexpr std::chrono::milliseconds kLong{603};  // no multiple of what it sleeps without a reason
  KioskSettings settled = settings();
  settled.exhibit.max_spp = 1;
  settled.gestures = {{.buttons = {"mode"}, .kind = GestureKind::kLong, .action = "compare", .after = kLong}};
  HeldButton button(synthetic_);
  Kiosk kiosk(display_, button, synthetic_, nullptr, workers_, fake_loader(world_), settled);
  display_.on_present = [&] {
    if (kiosk.hud().sides.size() < 2) return;
    EXPECT_EQ(synthetic_.now() - button.pressed, kLong);
    stop_ = true;
  };
  EXPECT_EQ(kiosk.run(stop_).presses, 1U);
}

TEST_F(KioskTest, ALoadUnderWayDoesNotKeepItFromEnding) {
  std::atomic<bool> go{false};
  const LoadScene load = [&](const PlaylistScene&, Numbers) {
    while (!go) std::this_thread::yield();
    return fake_scene(world_);
  };
  Kiosk kiosk(display_, buttons_, system_, nullptr, workers_, load, settings());
  display_.on_present = [&] { stop_ = kiosk.hud().loading; };
  kiosk.run(stop_);
  EXPECT_TRUE(kiosk.held_by_a_load());
  go = true;
  while (kiosk.held_by_a_load()) std::this_thread::yield();
}

TEST_F(KioskTest, TheSupervisorHearsWhichButtonsAreMissing) {
  TemporaryFolder runtime;
  std::vector<std::string> told;
  Supervisor supervisor({.governor = {}, .health = {}, .runtime_folder = runtime.path()},
                        Supervision([&](const std::string& message) { told.push_back(message); }, {}));
  KioskSettings once = settings();
  once.frames = 2;
  buttons_.missing = "button 'scene': no such line";
  Kiosk kiosk(display_, buttons_, system_, nullptr, workers_, fake_loader(world_), once,
              {.supervisor = &supervisor});
  testing::internal::CaptureStderr();
  kiosk.run(stop_);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "vitrine: button 'scene': no such line\n");
  ASSERT_FALSE(told.empty());
  EXPECT_NE(told[0].find("; button 'scene': no such line"), std::string::npos) << told[0];
  std::ifstream health(runtime.path() / "vitrine.prom");
  const std::string text{std::istreambuf_iterator<char>(health), {}};
  EXPECT_NE(text.find("\nvitrine_waiting_for_buttons 1\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace vitrine
