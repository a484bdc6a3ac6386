// The threads that do the work. One job at a time: a number of independent parts, taken by whichever thread
// is free. The caller goes on meanwhile, may look how far the job is, and may cancel it.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace vitrine {

class Workers {
 public:
  using Part = std::function<void(std::size_t)>;

  /// Starts `threads` of them, at least 1.
  explicit Workers(int threads);
  /// Cancels the job under way and ends the threads.
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  [[nodiscard]] int count() const { return static_cast<int>(threads_.size()); }

  /// Starts part(0) .. part(parts - 1) in any order and returns at once. The last job must have ended.
  void start(std::size_t parts, Part part);
  /// Whether the job has ended within `timeout`. Throws, once, what a part has thrown.
  bool wait_for(std::chrono::milliseconds timeout);
  /// Waits for the end of the job. Throws, once, what a part has thrown.
  void wait();
  /// Lets no further part begin and tells those under way by cancelled(); does not wait for their end.
  void ask_to_cancel();
  /// The same, and waits.
  void cancel();
  /// True from ask_to_cancel() to the next start(): what long parts look at.
  [[nodiscard]] const std::atomic<bool>& cancelled() const { return cancelled_; }

  /// A whole job: start() and wait().
  void for_each(std::size_t parts, Part part);

 private:
  void work();
  void rethrow_failure();

  std::mutex mutex_;
  std::condition_variable job_changed_;
  std::condition_variable job_ended_;
  Part part_;
  std::size_t parts_ = 0;
  std::size_t next_ = 0;     ///< the part that begins next
  std::size_t running_ = 0;  ///< parts under way
  bool quitting_ = false;
  std::exception_ptr failure_;
  std::atomic<bool> cancelled_{false};
  std::vector<std::thread> threads_;
};

/// One thread a core that this process may use.
int default_thread_count();

}  // namespace vitrine
