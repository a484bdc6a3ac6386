#include "workers.h"

#include <algorithm>
#include <utility>

namespace vitrine {

Workers::Workers(int threads) {
  for (int i = 0; i < std::max(threads, 1); ++i) threads_.emplace_back([this] { work(); });
}

Workers::~Workers() {
  cancel();
  {
    const std::lock_guard lock(mutex_);
    quitting_ = true;
  }
  job_changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workers::start(std::size_t parts, Part part) {
  {
    const std::lock_guard lock(mutex_);
    cancelled_ = false;
    failure_ = nullptr;
    part_ = std::move(part);
    parts_ = parts;
    next_ = 0;
  }
  job_changed_.notify_all();
}

bool Workers::wait_for(std::chrono::milliseconds timeout) {
  {
    std::unique_lock lock(mutex_);
    if (!job_ended_.wait_for(lock, timeout, [this] { return next_ == parts_ && running_ == 0; }))
      return false;
  }
  rethrow_failure();
  return true;
}

void Workers::wait() {
  {
    std::unique_lock lock(mutex_);
    job_ended_.wait(lock, [this] { return next_ == parts_ && running_ == 0; });
  }
  rethrow_failure();
}

void Workers::ask_to_cancel() {
  const std::lock_guard lock(mutex_);
  cancelled_ = true;
  next_ = parts_;
}

void Workers::cancel() {
  ask_to_cancel();
  std::unique_lock lock(mutex_);
  job_ended_.wait(lock, [this] { return running_ == 0; });
  failure_ = nullptr;
}

void Workers::for_each(std::size_t parts, Part part) {
  start(parts, std::move(part));
  wait();
}

void Workers::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    job_changed_.wait(lock, [this] { return quitting_ || next_ < parts_; });
    if (quitting_) return;
    const std::size_t mine = next_++;
    ++running_;
    lock.unlock();
    std::exception_ptr failure;
    try {
      part_(mine);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    --running_;
    if (failure) {
      failure_ = failure;
      next_ = parts_;
    }
    if (next_ == parts_ && running_ == 0) job_ended_.notify_all();
  }
}

void Workers::rethrow_failure() {
  std::exception_ptr failure;
  {
    const std::lock_guard lock(mutex_);
    failure = std::exchange(failure_, nullptr);
  }
  if (failure) std::rethrow_exception(failure);
}

int default_thread_count() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace vitrine
