#include "kiosk.h"

#include <algorithm>
#include <exception>
#include <thread>
#include <utility>

#include "picture_view.h"
#include "screenshots.h"
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
/// How long the labels say that the config was read anew, or why not.
constexpr std::chrono::seconds kRefitTime{15};
constexpr int kExposureStep = 2;  // quarter stops
constexpr int kSplitSteps = 16;   // over the width
constexpr std::chrono::nanoseconds kSyntheticFrame{1'000'000'000 / 60};

ExhibitSettings sized(ExhibitSettings settings, const DisplayMode& mode) {
  settings.size = {mode.width, mode.height};
  return settings;
}

}  // namespace

Kiosk::Kiosk(Display& display, Buttons& buttons, const TimeSource& clock, SyntheticClock* stepped,
             Workers& workers, LoadScene load, KioskSettings settings, KioskCare care)
    : display_(display),
      buttons_(buttons),
      clock_(clock),
      stepped_(stepped),
      last_frame_(settings.frames),
      care_(std::move(care)),
      screenshot_folder_(std::move(settings.screenshot_folder)),
      complaint_(std::move(settings.complaint)),
      exhibit_(sized(std::move(settings.exhibit), display.mode()),
               stepped != nullptr ? Pace::kStepped : Pace::kLive, workers, std::move(load)),
      tour_(std::move(settings.lecture)),
      manners_(std::move(settings.manners), clock.now()),
      gestures_(settings.gestures),
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
  refit();
  mind_manners();
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
  refit();
  mind_manners();
  fit_display();
  // With nothing to do the session goes on at the speed of a real one.
  if (!exhibit_.advance({})) std::this_thread::sleep_for(kSyntheticFrame);
  present();
  stepped_->advance(kSyntheticFrame);
}

std::chrono::milliseconds Kiosk::idle_patience() const {
  const std::optional<Clock::time_point> deadline = gestures_.deadline();
  if (!deadline) return kIdlePatience;
  const auto left = std::chrono::ceil<milliseconds>(*deadline - clock_.now());
  return std::clamp(left, milliseconds(0), kIdlePatience);
}

void Kiosk::take_presses() {
  // Live, a press without a trustworthy time may have come right after the buttons were last looked at.
  const Clock::time_point earliest = polled_;
  const std::vector<ButtonEvent> events = buttons_.poll(idle_ ? idle_patience() : milliseconds(0));
  polled_ = Clock::now();
  for (const Gesture& gesture : gestures_.take(events, clock_.now())) {
    const ActionButton* const button = find_action(gesture.action);
    if (button == nullptr) continue;
    ++report_.presses;
    const Clock::time_point trigger = stepped_ != nullptr ? polled_ : std::min(earliest, gesture.time);
    unanswered_ = unanswered_ ? std::min(*unanswered_, trigger) : trigger;
    manners_.touched(clock_.now());
    notify("", kLabelTime);
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
      return save_shown();
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

void Kiosk::refit() {
  std::optional<Refit> refit = care_.take_refit ? care_.take_refit() : std::nullopt;
  if (!refit) return;
  notify(refit->notice, kRefitTime);
  if (!refit->settings) return;
  KioskSettings& settings = *refit->settings;
  exhibit_.refit(sized(std::move(settings.exhibit), display_.mode()));
  tour_ = LectureTour(std::move(settings.lecture));
  manners_ = Manners(std::move(settings.manners), clock_.now());
  gestures_ = GestureRecogniser(settings.gestures);
  screenshot_folder_ = std::move(settings.screenshot_folder);
  complaint_ = std::move(settings.complaint);
}

void Kiosk::mind_manners() {
  const Clock::time_point now = clock_.now();
  const bool by_lecture = manners_.idle().tour == IdleTour::kLecture && !tour_.empty();
  switch (manners_.idle_step(now)) {
    case IdleStep::kNone:
      break;
    case IdleStep::kReset:
      restore();
      break;
    case IdleStep::kBegin:
      restore();  // which shows the first scene
      if (by_lecture) next_stop();
      break;
    case IdleStep::kNext:
      if (by_lecture) {
        next_stop();
      } else {
        exhibit_.turn_scene(1);
      }
      break;
  }
  const bool seen = manners_.brightness(now) > 0.0 && !display_.waiting_for_screen();
  const double duty = care_.supervisor != nullptr ? care_.supervisor->duty() : 1.0;
  exhibit_.set_duty(seen ? duty : 0.0);
}

void Kiosk::restore() {
  exhibit_.begin();
  tour_.restart();
  hud_on_ = true;
  split_ = kSplitSteps / 2;
  notice_.clear();
}

void Kiosk::notify(const std::string& notice, Clock::duration time) {
  notice_ = notice;
  labels_until_ = clock_.now() + time;
}

void Kiosk::move_split(int steps) { split_ = std::clamp(split_ + steps, 0, kSplitSteps); }

void Kiosk::save_shown() {
  std::string name = exhibit_.scene().name;
  for (const std::unique_ptr<Side>& side : exhibit_.sides())
    name += "-" + std::string(side->technique.mode->key) + "-" + std::to_string(side->samples()) + "spp";
  try {
    notice_ = "saved " + save_screenshot(screenshot_folder_, name, read_picture(display_.shown()));
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
  state.done = exhibit_.done();
  if (care_.supervisor != nullptr) state.governor = care_.supervisor->governor_line();
  if (pressed_lately) state.notice = notice_;
  state.error = exhibit_.error();
  state.error_title = state.title + " cannot be shown";
  state.over_picture = exhibit_.standing_in();
  if (state.error.empty() && !complaint_.empty()) {
    state.error = complaint_;
    state.error_title = "This box needs help";
    state.over_picture = true;
  }
  state.offset = manners_.label_offset(clock_.now());
  return state;
}

void Kiosk::present() {
  count_rays();
  hud_ = describe();
  const Surface surface = display_.acquire();
  if (hud_.error.empty() || hud_.over_picture)
    show_sides(surface, exhibit_.sides(), split_column(hud_.split, surface.width));
  draw_hud(surface, hud_);
  dim_surface(surface, manners_.brightness(clock_.now()));
  display_.present();

  presented_ = Clock::now();
  frame_rate_.count(clock_.now(), 1);
  ++report_.frames;
  if (unanswered_) {
    const std::chrono::duration<double, std::milli> answer =
        presented_ - *std::exchange(unanswered_, std::nullopt);
    report_.slowest_press_ms = std::max(report_.slowest_press_ms, answer.count());
  }
  tell_supervisor();
}

void Kiosk::tell_supervisor() {
  if (care_.supervisor == nullptr) return;
  care_.supervisor->presented({.time = presented_,
                               .scene = exhibit_.scene().name,
                               .mode = std::string(exhibit_.sides().back()->technique.mode->key),
                               .frames_per_second = frame_rate_.per_second(),
                               .traced = exhibit_.tracing(),
                               .failing = !hud_.error.empty(),
                               .waiting_for_screen = display_.waiting_for_screen(),
                               .buttons_notice = buttons_.notice(),
                               .presses = report_.presses,
                               .slowest_press_s = report_.slowest_press_ms / 1000.0});
}

}  // namespace vitrine
