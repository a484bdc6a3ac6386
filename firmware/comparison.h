// Side by side, fairly: passes alternate so that both sides have equally many samples, or that the workers
// were at both for equally long.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace vitrine {

enum class Fairness : std::uint8_t { kEqualSamples, kEqualTime };

constexpr std::string_view fairness_label(Fairness fairness) {
  return fairness == Fairness::kEqualSamples ? "equal samples" : "equal time";
}

/// What a side has had.
struct Share {
  std::uint32_t samples = 0;  ///< a pixel
  std::int64_t spent = 0;     ///< time, in any unit that both sides use
};

/// The side that goes on: the first unless it is ahead.
constexpr std::size_t whose_turn(Fairness fairness, const Share& first, const Share& second) {
  const bool behind =
      fairness == Fairness::kEqualSamples ? second.samples < first.samples : second.spent < first.spent;
  return behind ? 1 : 0;
}

/// How many samples the side goes on by: `pass` as suits it, but not past a partner that it has to catch up
/// with, nor further ahead of one than `partners_pass`.
constexpr std::uint32_t turn_length(Fairness fairness, const Share& side, std::uint32_t pass,
                                    const Share& partner, std::uint32_t partners_pass) {
  if (fairness == Fairness::kEqualTime) return pass;
  if (side.samples < partner.samples) return std::min(pass, partner.samples - side.samples);
  return std::min(pass, partners_pass);
}

}  // namespace vitrine
