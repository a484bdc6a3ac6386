#include "readable.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

#include <poll.h>

namespace vitrine {

bool readable_now(int descriptor) {
  pollfd one{.fd = descriptor, .events = POLLIN, .revents = 0};
  return poll(&one, 1, 0) > 0;
}

void wait_readable(std::span<const int> descriptors, Clock::time_point until) {
  std::vector<pollfd> all;
  for (const int descriptor : descriptors) all.push_back({.fd = descriptor, .events = POLLIN, .revents = 0});
  // Rounded up: a wait that ends early would be followed by a busy one. A signal may end it, which is
  // harmless.
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
  const auto patience = std::clamp<std::chrono::milliseconds::rep>(left.count(), 0, 60'000);
  poll(all.data(), static_cast<nfds_t>(all.size()), static_cast<int>(patience));
}

}  // namespace vitrine
