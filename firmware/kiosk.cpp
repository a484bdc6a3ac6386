#include "kiosk.h"

#include <algorithm>
#include <exception>
#include <thread>
#include <utility>

#include "film/image_files.h"
#include "picture_view.h"
#include "side_label.h"

namespace vitrine {
namespace {

using std::chrono::milliseconds;

/// How long a press may wait for the loop: while a pass runs, and while nothing happens.
constexpr milliseconds kPassPatience{3};
constexpr milliseconds kIdlePatience{10};
/// A still picture is shown again this often: a window may have been covered.
constexpr milliseconds kStillPeriod{250};
/// How long a press shows the labels when the HUD is off.
constexpr std::chrono::seconds kLabelTime{2};
constexpr int kExposureStep = 2;  // quarter stops
constexpr int kSplitSteps = 16;   // over the width
constexpr std::chrono::nanoseconds kSyntheticFrame{1'000'000'000 / 60};

ExhibitSettings sized(ExhibitSettings settings, const DisplayMode& mode) {
  settings.size = {mode.width, mode.height};
  return settings;
}

}  // namespace

Kiosk::Kiosk(Display& display, Buttons& buttons, const TimeSource& clock, SyntheticClock* stepped,
             Workers& workers, LoadScene load, KioskSettings settings)
    : display_(display),
      buttons_(buttons),
      clock_(clock),
      stepped_(stepped),
      last_frame_(settings.frames),
      screenshot_folder_(std::move(settings.screenshot_folder)),
      exhibit_(sized(std::move(settings.exhibit), display.mode()),
               stepped != nullptr ? Pace::kStepped : Pace::kLive, workers, std::move(load)),
      tour_(std::move(settings.lecture)),
      split_(kSplitSteps / 2) {}

KioskReport Kiosk::run(const std::atomic<bool>& stop) {
  const Clock::time_point began = Clock::now();
  polled_ = began;
  ticked_ = clock_.now();
  labels_until_ = ticked_;
  while (!stop && !quitting_ && report_.frames < last_frame_) {
    if (stepped_ != nullptr) {
      stepped_step();
    } else {
      live_step();
    }
  }
  report_.seconds = std::chrono::duration<double>(Clock::now() - began).count();
  return report_;
}

void Kiosk::live_step() {
  take_presses();
  fit_display();
  // A press is answered first; what it costs to make the new picture comes after.
  const bool changed = !unanswered_ && exhibit_.advance(kPassPatience);
  idle_ = !unanswered_ && !changed && !exhibit_.tracing();
  if (changed || unanswered_ || hud_text(describe()) != hud_text(hud_) ||
      Clock::now() - presented_ > kStillPeriod) {
    present();
  }
}

void Kiosk::stepped_step() {
  take_presses();
  fit_display();
  // With nothing to do the session goes on at the speed of a real one.
  if (!exhibit_.advance({})) std::this_thread::sleep_for(kSyntheticFrame);
  present();
  stepped_->advance(kSyntheticFrame);
}

void Kiosk::take_presses() {
  // Live, a press may have come right after the buttons were last looked at.
  const Clock::time_point earliest = polled_;
  const std::vector<ButtonEvent> events = buttons_.poll(idle_ ? kIdlePatience : milliseconds(0));
  polled_ = Clock::now();
  for (const ButtonEvent& event : events) {
    const ActionButton* const button = event.edge == Edge::kPress ? find_action(event.button) : nullptr;
    if (button == nullptr) continue;
    ++report_.presses;
    if (!unanswered_) unanswered_ = stepped_ != nullptr ? polled_ : earliest;
    labels_until_ = clock_.now() + kLabelTime;
    notice_.clear();
    perform(*button);
  }
}

void Kiosk::perform(const ActionButton& button) {
  if (button.leaves_lecture) tour_.leave();
  switch (button.action) {
    case Action::kNextScene:
      return exhibit_.turn_scene(1);
    case Action::kPreviousScene:
      return exhibit_.turn_scene(-1);
    case Action::kNextMode:
      return exhibit_.turn_mode(1);
    case Action::kPreviousMode:
      return exhibit_.turn_mode(-1);
    case Action::kParameter:
      return exhibit_.turn_parameter(*button.parameter);
    case Action::kLecture:
      return next_stop();
    case Action::kCompare:
      return exhibit_.toggle_comparison();
    case Action::kFairness:
      return exhibit_.toggle_fairness();
    case Action::kSplitLeft:
      return move_split(-1);
    case Action::kSplitRight:
      return move_split(1);
    case Action::kView:
      return exhibit_.turn_view(1);
    case Action::kNumbers:
      return exhibit_.switch_numbers();
    case Action::kPause:
      return exhibit_.set_paused(!exhibit_.paused());
    case Action::kBrighter:
      return exhibit_.brighten(kExposureStep);
    case Action::kDarker:
      return exhibit_.brighten(-kExposureStep);
    case Action::kAutoExposure:
      return exhibit_.use_auto_exposure();
    case Action::kHud:
      hud_on_ = !hud_on_;
      return;
    case Action::kScreenshot:
      return save_screenshot();
    case Action::kQuit:
      quitting_ = true;
      return;
  }
}

void Kiosk::next_stop() {
  if (tour_.empty()) {
    notice_ = "no lecture is installed; name one with --lecture FILE";
    return;
  }
  const LectureStop& stop = tour_.go_on();
  exhibit_.show(stop.scene, stop.techniques, stop.fairness);
}

void Kiosk::move_split(int steps) { split_ = std::clamp(split_ + steps, 0, kSplitSteps); }

void Kiosk::save_screenshot() {
  std::string name = "vitrine-" + exhibit_.scene().name;
  for (const std::unique_ptr<Side>& side : exhibit_.sides())
    name += "-" + std::string(side->technique.mode->key) + "-" + std::to_string(side->samples()) + "spp";
  name += ".png";
  try {
    const DevelopedPicture picture = read_picture(display_.shown());
    write_png(screenshot_folder_ / name, picture.width, picture.height, picture.rgb);
    notice_ = "saved " + name;
  } catch (const std::exception& error) {
    notice_ = error.what();
  }
}

void Kiosk::fit_display() {
  const DisplayMode mode = display_.mode();
  exhibit_.resize({mode.width, mode.height});
  const Clock::time_point now = clock_.now();
  if (edition_ != exhibit_.edition()) {
    edition_ = exhibit_.edition();
    exposing_ = {};
  } else if (!exhibit_.paused()) {
    exposing_ += now - ticked_;
  }
  ticked_ = now;
}

void Kiosk::count_rays() {
  // A pass may take longer than the rate's period: only its end is worth counting.
  if (exhibit_.rays() == counted_rays_) return;
  ray_rate_.count(clock_.now(), exhibit_.rays() - counted_rays_);
  counted_rays_ = exhibit_.rays();
}

HudState Kiosk::describe() const {
  const bool pressed_lately = clock_.now() < labels_until_;
  HudState state;
  state.visible = hud_on_ || pressed_lately;
  state.title = tour_.stop() != nullptr ? tour_.title() : exhibit_.scene().title;
  state.caption = tour_.stop() != nullptr ? tour_.stop()->caption : exhibit_.scene().caption;
  state.sides.clear();
  const std::span<const std::unique_ptr<Side>> sides = exhibit_.sides();
  for (const std::unique_ptr<Side>& side : sides) {
    const Side& other = side == sides.front() ? *sides.back() : *sides.front();
    state.sides.push_back(side_label(side->technique, &other.technique, side->samples(), side->error));
  }
  state.split = static_cast<double>(split_) / kSplitSteps;
  state.fairness = fairness_label(exhibit_.fairness());
  state.view = exhibit_.view().label;
  state.view_legend = exhibit_.view().legend;
  state.numbers = numbers_name(exhibit_.numbers());
  state.frames_per_second = frame_rate_.per_second();
  state.rays_per_second = ray_rate_.per_second();
  state.seconds = std::chrono::duration<double>(exposing_).count();
  if (const auto exposure = exhibit_.manual_exposure()) state.exposure_stops = exposure->quarter_stops / 4.0;
  state.paused = exhibit_.paused();
  state.loading = exhibit_.loading();
  if (pressed_lately) state.notice = notice_;
  state.error = exhibit_.error();
  return state;
}

void Kiosk::present() {
  count_rays();
  hud_ = describe();
  const Surface surface = display_.acquire();
  if (hud_.error.empty()) show_sides(surface, exhibit_.sides(), split_column(hud_.split, surface.width));
  draw_hud(surface, hud_);
  display_.present();

  presented_ = Clock::now();
  frame_rate_.count(clock_.now(), 1);
  ++report_.frames;
  if (unanswered_) {
    const std::chrono::duration<double, std::milli> answer =
        presented_ - *std::exchange(unanswered_, std::nullopt);
    report_.slowest_press_ms = std::max(report_.slowest_press_ms, answer.count());
  }
}

}  // namespace vitrine
