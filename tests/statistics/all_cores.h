// Independent pieces of work on all cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace vitrine {

/// Calls work(i) for i in [0, count) on `threads` threads, each piece once, in no particular order.
template <class Work>
void for_each_on(unsigned threads, int count, const Work& work) {
  std::atomic<int> next{0};
  std::vector<std::jthread> workers;
  for (unsigned t = 0; t < threads; ++t) {
    workers.emplace_back([&] {
      for (int i = next++; i < count; i = next++) work(i);
    });
  }
}

template <class Work>
void for_each_on_all_cores(int count, const Work& work) {
  for_each_on(std::max(1U, std::thread::hardware_concurrency()), count, work);
}

}  // namespace vitrine
