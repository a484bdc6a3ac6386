#include "merged_buttons.h"

#include <algorithm>
#include <thread>

namespace vitrine {

std::vector<ButtonEvent> MergedButtons::poll(std::chrono::milliseconds timeout) {
  constexpr std::chrono::milliseconds kStep{2};  // no source can wait for the others
  const Clock::time_point deadline = Clock::now() + timeout;
  std::vector<ButtonEvent> events;
  while (true) {
    for (const auto& source : sources_) {
      for (ButtonEvent& event : source->poll(std::chrono::milliseconds{0}))
        events.push_back(std::move(event));
    }
    const Clock::duration left = deadline - Clock::now();
    if (!events.empty() || left <= Clock::duration::zero()) break;
    std::this_thread::sleep_for(std::min<Clock::duration>(left, kStep));
  }
  std::ranges::stable_sort(events, {}, &ButtonEvent::time);
  return events;
}

std::string MergedButtons::notice() const {
  std::string all;
  for (const auto& source : sources_) {
    const std::string notice = source->notice();
    if (!notice.empty()) all += (all.empty() ? "" : ". ") + notice;
  }
  return all;
}

}  // namespace vitrine
