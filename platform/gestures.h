// What edges of buttons mean. A press becomes exactly one of: a short press, a long press (fires at its
// threshold, while still held), or part of a chord (several buttons pressed within a window). While a button
// stays down after that, it may repeat.
//
// A press answers as early as its rules allow: at its edge where nothing else is possible, at the end of the
// chord's window or at the release where something is.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "buttons.h"

namespace vitrine {

enum class GestureKind : std::uint8_t { kShort, kLong, kRepeat, kChord };

inline constexpr std::chrono::milliseconds kLongPress{800};
inline constexpr std::chrono::milliseconds kRepeatDelay{500};
inline constexpr std::chrono::milliseconds kRepeatPeriod{200};
inline constexpr std::chrono::milliseconds kChordWindow{100};

struct GestureRule {
  std::vector<std::string> buttons;  ///< one; for a chord two or more
  GestureKind kind = GestureKind::kShort;
  std::string action;  ///< what to do: the name of an action
  /// Long: how long to hold. Repeat: from the press to the first repeat. Chord: less than this lies between
  /// the first press and the last. Short: not used. 0: the default of the kind.
  std::chrono::milliseconds after{0};
  std::chrono::milliseconds every{0};  ///< repeat: the period; 0: the default
};

/// What is wrong with rules[index], alone or beside the rules before it: "PROBLEM; REMEDY", or empty.
[[nodiscard]] std::string rule_problem(std::span<const GestureRule> rules, std::size_t index);

struct Gesture {
  std::string action;
  GestureKind kind = GestureKind::kShort;
  Clock::time_point time;  ///< of the edge or the deadline that completed it
};

class GestureRecogniser {
 public:
  /// A button without a rule for short presses has one all the same: it does what its rule for repeats does,
  /// or else the action of its own name. Throws std::invalid_argument for rules that rule_problem() objects
  /// to.
  explicit GestureRecogniser(std::span<const GestureRule> rules = {});

  /// Takes events, oldest first, and the time up to which all are known; gives the gestures that this
  /// completes, in order. Copes with whatever sources do: the press of what is held ends the press before,
  /// the release of what is not is nothing.
  [[nodiscard]] std::vector<Gesture> take(std::span<const ButtonEvent> events, Clock::time_point now);

  /// When to call take() even without an event; none: a press is needed first.
  [[nodiscard]] std::optional<Clock::time_point> deadline() const;

 private:
  /// What the rules say about one button.
  struct Manners {
    std::string short_action;
    std::optional<GestureRule> long_press;
    std::optional<GestureRule> repeat;
    std::chrono::milliseconds chord_window{0};  ///< the longest of its chords; 0: it is in none
  };
  /// A button that is down.
  struct Press {
    Clock::time_point began;
    bool decided = false;                          ///< it was a short, a long press or part of a chord
    std::optional<Clock::time_point> chord_until;  ///< undecided: how long a chord may still come
    std::optional<Clock::time_point> long_at;      ///< undecided
    std::optional<Clock::time_point> next_repeat;  ///< decided
    [[nodiscard]] std::optional<Clock::time_point> deadline() const;
  };

  /// How far a chord has come.
  struct Span {
    std::size_t missing;  ///< buttons that are not down
    Clock::time_point first;
    Clock::time_point last;
  };

  [[nodiscard]] Manners manners_of(const std::string& button) const;
  void press(const std::string& button, Clock::time_point time);
  void release(const std::string& button, Clock::time_point time);
  /// Lets everything happen that is due by `time`.
  void advance(Clock::time_point time);
  void meet_deadline(const std::string& button, Press& press, Clock::time_point horizon);
  /// Makes an undecided press the chord that it completes, and otherwise `action`.
  void decide(const std::string& button, GestureKind kind, const std::string& action, Clock::time_point time);
  /// The largest chord with this button that is down, or nullptr.
  [[nodiscard]] const GestureRule* complete_chord(const std::string& button) const;
  /// How long a larger chord around this one may still come.
  [[nodiscard]] std::optional<Clock::time_point> grows_until(const GestureRule& chord,
                                                             Clock::time_point time) const;
  /// None when one of its buttons has been decided otherwise.
  [[nodiscard]] std::optional<Span> span_of(const GestureRule& chord) const;

  std::vector<GestureRule> chords_;         ///< the largest first
  std::map<std::string, Manners> manners_;  ///< of the buttons with rules
  std::map<std::string, Press> down_;
  std::vector<Gesture> done_;
};

}  // namespace vitrine
