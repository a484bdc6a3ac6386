// A contact that closes or opens bounces for some milliseconds. The debouncer waits until it has been quiet,
// and then believes the level, not the edges: an edge that the kernel lost, doubled or saw from the wrong
// side cannot leave a button stuck.
//
//     contact  ____|-|_|--|_|-----------------|_|-|_________
//     reports      |<-- quiet -->press        |<- quiet ->release
//
// A level that lasted less than the quiet time was noise. What is reported has the time of its first edge,
// when the finger came.
#pragma once

#include <chrono>
#include <optional>

#include "buttons.h"

namespace vitrine {

class Debouncer {
 public:
  struct Change {
    bool active;
    Clock::time_point time;
  };

  /// A contact that counts as open whatever it is now: one that is stuck, or held while the box starts, is no
  /// press. With a `quiet` of 0 each edge counts.
  explicit Debouncer(Clock::duration quiet) : quiet_(quiet) {}

  /// An edge that led to `level`, in order of time. Reports what had been quiet before it: a loop that looks
  /// late still sees every press.
  std::optional<Change> edge(bool level, Clock::time_point time) {
    std::optional<Change> change;
    if (restless_ && time - last_edge_ >= quiet_) change = believe(edge_level_);
    if (!restless_) first_edge_ = time;
    restless_ = true;
    last_edge_ = time;
    edge_level_ = level;
    return change;
  }

  /// When to read the level, if no edge comes before; none: the contact is at rest.
  [[nodiscard]] std::optional<Clock::time_point> deadline() const {
    return restless_ ? std::optional(last_edge_ + quiet_) : std::nullopt;
  }

  /// The level at the deadline, or later if no edge is known to have come since.
  std::optional<Change> settle(bool level) { return restless_ ? believe(level) : std::nullopt; }

 private:
  std::optional<Change> believe(bool level) {
    restless_ = false;
    if (level == active_) return std::nullopt;
    active_ = level;
    return Change{level, first_edge_};
  }

  Clock::duration quiet_;
  bool active_ = false;
  // Since the contact was last at rest:
  bool restless_ = false;
  Clock::time_point first_edge_{};
  Clock::time_point last_edge_{};
  bool edge_level_ = false;  ///< after the last edge
};

}  // namespace vitrine
