// Labels that stand still for months burn into a panel: they walk around a small ring, a step a minute, too
// slowly and too little to be noticed.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

#include "buttons.h"

namespace vitrine {

struct PixelOffset {
  int x = 0;
  int y = 0;

  bool operator==(const PixelOffset&) const = default;
};

inline constexpr std::chrono::minutes kPixelShiftPeriod{1};

inline constexpr int kMaxPixelShift = 4;

/// Where the labels are `running` after the start: at home first, never more than kMaxPixelShift away to the
/// right and down, and moved by at most 2 pixels a step.
[[nodiscard]] inline PixelOffset pixel_shift(Clock::duration running) {
  constexpr std::array<PixelOffset, 8> kRing{
      {{0, 0}, {2, 0}, {4, 0}, {4, 2}, {4, 4}, {2, 4}, {0, 4}, {0, 2}}};
  return kRing[static_cast<std::size_t>(running / kPixelShiftPeriod) % kRing.size()];
}

}  // namespace vitrine
