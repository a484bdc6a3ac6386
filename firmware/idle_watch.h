// What the box does when nobody touches it: after a while it goes back to how it began, and after another it
// shows itself, step by step, until the next press. On injected time.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "buttons.h"

namespace vitrine {

enum class IdleTour : std::uint8_t { kLecture, kScenes };

/// Nothing: it does not.
struct IdleSettings {
  std::optional<std::chrono::milliseconds> after;  ///< without a press the tour begins
  std::chrono::milliseconds every{20'000};         ///< a step of the tour
  std::optional<std::chrono::milliseconds> reset;  ///< without a press all is as it was in the beginning
  IdleTour tour = IdleTour::kLecture;              ///< what the tour steps through; scenes without a lecture

  bool operator==(const IdleSettings&) const = default;
};

enum class IdleStep : std::uint8_t {
  kNone,
  kReset,  ///< back to how it began
  kBegin,  ///< back, and the first step of the tour
  kNext,   ///< its next step
};

class IdleWatch {
 public:
  IdleWatch(const IdleSettings& settings, Clock::time_point now) : settings_(settings), touched_(now) {}

  void touched(Clock::time_point now) {
    touched_ = now;
    stepped_.reset();
    is_reset_ = false;
  }
  /// Whether the tour is under way.
  [[nodiscard]] bool touring() const { return stepped_.has_value(); }

  /// What is due, each once.
  [[nodiscard]] IdleStep due(Clock::time_point now) {
    if (stepped_) {
      if (now - *stepped_ < settings_.every) return IdleStep::kNone;
      stepped_ = now;
      return IdleStep::kNext;
    }
    if (settings_.after && now - touched_ >= *settings_.after) {
      stepped_ = now;
      return IdleStep::kBegin;
    }
    if (settings_.reset && !is_reset_ && now - touched_ >= *settings_.reset) {
      is_reset_ = true;
      return IdleStep::kReset;
    }
    return IdleStep::kNone;
  }

 private:
  IdleSettings settings_;
  Clock::time_point touched_;
  std::optional<Clock::time_point> stepped_;  ///< the latest step of the tour under way
  bool is_reset_ = false;                     ///< since the latest press
};

}  // namespace vitrine
