// A box without a fan must not cook itself: above one temperature it works less, step by step, below a lower
// one it recovers, and in between it leaves things as they are, so that it never swings between the two.
// Pure: readings and time are injected.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "buttons.h"

namespace vitrine {

struct ThermalLimits {
  double hot_c = 80.0;   ///< from here on it works less
  double cool_c = 70.0;  ///< from here down it recovers

  bool operator==(const ThermalLimits&) const = default;
};

/// What the sensors say; nothing: there are none, or they cannot be read.
struct ThermalReading {
  std::optional<double> temperature_c;
  std::optional<bool> throttled;  ///< the machine has slowed itself down

  bool operator==(const ThermalReading&) const = default;
};

class ThermalGovernor {
 public:
  /// A step has this long to show what it does.
  static constexpr std::chrono::seconds kStepTime{10};
  static constexpr int kMaxStep = 4;

  explicit ThermalGovernor(const ThermalLimits& limits) : limits_(limits) {}

  /// Takes a reading; without any the load stays as it is.
  void take(const ThermalReading& reading, Clock::time_point now) {
    if (changed_ && now - *changed_ < kStepTime) return;
    const bool hot = reading.throttled.value_or(false) ||
                     (reading.temperature_c && *reading.temperature_c >= limits_.hot_c);
    const bool cool = !reading.throttled.value_or(false) && reading.temperature_c &&
                      *reading.temperature_c <= limits_.cool_c;
    const bool released = !hot && !reading.temperature_c && reading.throttled;  // by the flag alone
    const int step = std::clamp(step_ + (hot ? 1 : cool || released ? -1 : 0), 0, kMaxStep);
    if (step == step_) return;
    step_ = step;
    changed_ = now;
  }

  /// The part of its time that the tracer may work: 1, 1/2, ... 1/16.
  [[nodiscard]] double duty() const { return 1.0 / static_cast<double>(1 << step_); }
  [[nodiscard]] int step() const { return step_; }

 private:
  ThermalLimits limits_;
  int step_ = 0;
  std::optional<Clock::time_point> changed_;  ///< when step_ was
};

}  // namespace vitrine
