// How much of something there is a second, frames or rays: told twice a second, so that people can read it.
#pragma once

#include <chrono>
#include <cstdint>

#include "buttons.h"

namespace vitrine {

class Rate {
 public:
  /// So much was done since the last call.
  void count(Clock::time_point now, std::uint64_t amount) {
    if (!begun_) began_ = now;
    begun_ = true;
    const std::chrono::duration<double> span = now - began_;
    if (span >= kPeriod) {
      per_second_ = static_cast<double>(amount_) / span.count();
      began_ = now;
      amount_ = 0;
    }
    amount_ += amount;
  }

  /// Over the latest whole period; 0 before the first has ended.
  [[nodiscard]] double per_second() const { return per_second_; }

 private:
  static constexpr std::chrono::milliseconds kPeriod{500};

  bool begun_ = false;
  Clock::time_point began_;
  std::uint64_t amount_ = 0;  ///< since then
  double per_second_ = 0.0;
};

}  // namespace vitrine
