// Frames per second, told twice a second so that people can read it.
#pragma once

#include <chrono>

#include "buttons.h"

namespace vitrine {

class FrameRate {
 public:
  /// A frame was shown.
  void count(Clock::time_point now) {
    if (frames_ == 0) began_ = now;
    const std::chrono::duration<double> span = now - began_;
    if (span >= kPeriod) {
      per_second_ = static_cast<double>(frames_) / span.count();
      began_ = now;
      frames_ = 0;
    }
    ++frames_;
  }

  /// Over the latest whole period; 0 before the first has ended.
  [[nodiscard]] double per_second() const { return per_second_; }

 private:
  static constexpr std::chrono::milliseconds kPeriod{500};

  Clock::time_point began_;
  int frames_ = 0;  ///< since then
  double per_second_ = 0.0;
};

}  // namespace vitrine
