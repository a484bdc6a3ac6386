// What tracing a tile did: counts, and the samples that were dropped, so that each can be made again and
// looked at.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine {

/// A sample that was dropped since its radiance was not finite or beyond the film's range. A render of this
/// pixel alone and this sample alone, with this seed, makes it again.
struct DroppedSample {
  int x = 0;
  int y = 0;
  std::uint32_t sample = 0;
  std::uint64_t seed = 0;

  bool operator==(const DroppedSample&) const = default;
};

struct TraceStats {
  static constexpr std::size_t kMaxDroppedRecords = 64;

  std::uint64_t samples = 0;
  std::uint64_t rays = 0;  ///< closest-hit and shadow rays
  std::uint64_t dropped = 0;
  std::vector<DroppedSample> dropped_samples;  ///< the first kMaxDroppedRecords of them
  bool cancelled = false;  ///< before the end; the wave under way left no trace on the film

  void drop(const DroppedSample& sample) {
    ++dropped;
    if (dropped_samples.size() < kMaxDroppedRecords) dropped_samples.push_back(sample);
  }
  TraceStats& operator+=(const TraceStats& other) {
    samples += other.samples;
    rays += other.rays;
    dropped += other.dropped;
    for (const DroppedSample& sample : other.dropped_samples) {
      if (dropped_samples.size() < kMaxDroppedRecords) dropped_samples.push_back(sample);
    }
    cancelled = cancelled || other.cancelled;
    return *this;
  }
};

}  // namespace vitrine
