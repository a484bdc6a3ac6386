// The pace of a display whose screen may be missing: how often it looks for one, and how long its frames take
// meanwhile, so that the program above neither spins nor sleeps.
#pragma once

#include <chrono>
#include <thread>

#include "buttons.h"

namespace vitrine {

class ScreenPace {
 public:
  [[nodiscard]] bool look_is_due() const { return Clock::now() >= next_look_; }
  void looked() { next_look_ = Clock::now() + std::chrono::seconds{1}; }

  /// A frame was shown, whose end the screen told.
  void presented() { presented_ = Clock::now(); }
  /// A frame that nobody saw ends 1/60 s after the one before.
  void wait_a_frame() {
    std::this_thread::sleep_until(presented_ + std::chrono::nanoseconds{1'000'000'000 / 60});
    presented();
  }

 private:
  Clock::time_point next_look_{};
  Clock::time_point presented_{};
};

}  // namespace vitrine
