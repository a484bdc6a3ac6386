// The two sources of time: the machine's clock, and one that goes only when told to, for scripted sessions
// and tests.
#pragma once

#include "buttons.h"

namespace vitrine {

class SystemClock final : public TimeSource {
 public:
  [[nodiscard]] Clock::time_point now() const override { return Clock::now(); }
};

/// Starts at Clock::time_point{} and stands still between calls of advance().
class SyntheticClock final : public TimeSource {
 public:
  [[nodiscard]] Clock::time_point now() const override { return now_; }
  void advance(Clock::duration by) { now_ += by; }

 private:
  Clock::time_point now_{};
};

}  // namespace vitrine
