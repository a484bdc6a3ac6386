// How the box behaves by itself: what it does when nobody touches it, when it shines less, and how its labels
// spare the panel. On injected time, clock and time of day alike.
#pragma once

#include <functional>
#include <vector>

#include "dim_schedule.h"
#include "idle_watch.h"
#include "pixel_shift.h"

namespace vitrine {

struct MannersSettings {
  IdleSettings idle;
  std::vector<DimSpan> dim;
  bool pixel_shift = false;
  std::function<TimeOfDay()> time_of_day = local_time_of_day;
};

/// A press makes a dimmed box as bright as ever for so long.
inline constexpr std::chrono::seconds kDimWake{60};

class Manners {
 public:
  Manners(MannersSettings settings, Clock::time_point now)
      : settings_(std::move(settings)), idle_(settings_.idle, now), began_(now) {}

  void touched(Clock::time_point now) {
    idle_.touched(now);
    woken_until_ = now + kDimWake;
  }
  [[nodiscard]] IdleStep idle_step(Clock::time_point now) { return idle_.due(now); }
  [[nodiscard]] const IdleSettings& idle() const { return settings_.idle; }
  [[nodiscard]] bool touring() const { return idle_.touring(); }
  /// 1: as bright as ever, 0: black.
  [[nodiscard]] double brightness(Clock::time_point now) const {
    if (settings_.dim.empty() || (woken_until_ && now < *woken_until_)) return 1.0;
    return dim_level(settings_.dim, settings_.time_of_day());
  }
  [[nodiscard]] PixelOffset label_offset(Clock::time_point now) const {
    return settings_.pixel_shift ? pixel_shift(now - began_) : PixelOffset{};
  }

 private:
  MannersSettings settings_;
  IdleWatch idle_;
  Clock::time_point began_;
  std::optional<Clock::time_point> woken_until_;
};

}  // namespace vitrine
