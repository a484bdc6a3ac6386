// The kiosk: buttons in, frames out. A press changes the label in the next frame, which is shown at once,
// even in the middle of a pass; the picture follows when there is one.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "actions.h"
#include "buttons.h"
#include "clocks.h"
#include "display.h"
#include "exhibit.h"
#include "gestures.h"
#include "hud.h"
#include "lecture.h"
#include "manners.h"
#include "rate.h"
#include "supervisor.h"

namespace vitrine {

struct KioskSettings {
  ExhibitSettings exhibit;           ///< the display says its size
  std::vector<LectureStop> lecture;  ///< what the button "lecture" steps through
  std::uint64_t frames = std::numeric_limits<std::uint64_t>::max();  ///< to present at most
  std::filesystem::path screenshot_folder = ".";
  std::vector<GestureRule> gestures{};  ///< of buttons that are more than their own action
  MannersSettings manners{};
  std::string complaint{};  ///< what is wrong with the whole box; a card says it over every scene
};

/// What a running kiosk is told to change.
struct Refit {
  std::optional<KioskSettings> settings{};  ///< instead of the old ones, but for the frames; nothing: stay
  std::string notice{};                     ///< for the labels
};

/// Who looks after a kiosk from outside; both may be left out.
struct KioskCare {
  Supervisor* supervisor = nullptr;
  std::function<std::optional<Refit>()> take_refit{};  ///< looked at before each frame
};

/// How a session went, on the machine's clock.
struct KioskReport {
  std::uint64_t frames = 0;
  double seconds = 0.0;
  std::uint64_t presses = 0;
  double slowest_press_ms =
      0.0;  ///< from a gesture's edge or deadline to the end of the present() that showed it
};

class Kiosk {
 public:
  /// Live on `clock`, or, when `stepped` is given (the same clock), in steps of one sample a pixel and 1/60 s
  /// a frame, which give the same frames on every machine. All references must outlive the kiosk.
  Kiosk(Display& display, Buttons& buttons, const TimeSource& clock, SyntheticClock* stepped,
        Workers& workers, LoadScene load, KioskSettings settings, KioskCare care = {});

  /// Runs until the button "quit", the last frame, or `stop`.
  KioskReport run(const std::atomic<bool>& stop);

  /// Whether its end would have to wait for the load of a scene, which may take seconds.
  [[nodiscard]] bool held_by_a_load() const { return exhibit_.held_by_a_load(); }

  /// What the labels of the latest frame say.
  [[nodiscard]] const HudState& hud() const { return hud_; }

 private:
  void take_presses();
  /// How long to wait for a press while nothing happens.
  [[nodiscard]] std::chrono::milliseconds idle_patience() const;
  void perform(const ActionButton& button);
  void next_stop();
  /// Takes other settings, if there are any.
  void refit();
  /// What it does by itself: the idle tour, and tracing only as much as it may.
  void mind_manners();
  /// As it was in the beginning.
  void restore();
  /// Shows a line for a while.
  void notify(const std::string& notice, Clock::duration time);
  void move_split(int steps);
  void save_shown();
  /// Follows the display's size and the time.
  void fit_display();
  void live_step();
  void stepped_step();
  void count_rays();
  [[nodiscard]] HudState describe() const;
  void present();
  void tell_supervisor();

  Display& display_;
  Buttons& buttons_;
  const TimeSource& clock_;
  SyntheticClock* const stepped_;
  const std::uint64_t last_frame_;
  const KioskCare care_;
  std::filesystem::path screenshot_folder_;
  std::string complaint_;
  Exhibit exhibit_;
  LectureTour tour_;
  Manners manners_;
  GestureRecogniser gestures_;

  bool quitting_ = false;
  bool idle_ = false;  ///< nothing to do but to wait for a press
  bool hud_on_ = true;
  Clock::time_point labels_until_;  ///< a press shows the labels even when the HUD is off
  std::string notice_;              ///< shown as long as they are
  int split_;                       ///< where two sides meet, in steps
  Rate frame_rate_;
  Rate ray_rate_;
  std::uint64_t counted_rays_ = 0;
  std::uint64_t edition_ = 0;    ///< of the picture that exposing_ is about
  Clock::duration exposing_{0};  ///< since it was asked for, pauses not counted
  Clock::time_point ticked_;     ///< when exposing_ was brought up to date
  HudState hud_;

  // On the machine's clock:
  Clock::time_point polled_;  ///< when the buttons were last known to be up to date
  Clock::time_point presented_;
  std::optional<Clock::time_point> unanswered_;  ///< the earliest gesture whose label was not shown yet
  KioskReport report_;
};

}  // namespace vitrine
