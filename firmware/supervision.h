// What the service manager is told, and when: ready once a frame was shown, alive for as long as frames are
// shown or a screen is deliberately waited for, and a line of status. No timer feeds the watchdog: a loop
// that hangs is a service that hangs. On injected time.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "buttons.h"

namespace vitrine {

class Supervision {
 public:
  using Send = std::function<void(const std::string&)>;

  /// Until when the manager is asked to wait for a screen, each time; a third of it passes between two asks.
  static constexpr std::chrono::seconds kScreenPatience{30};
  static constexpr std::chrono::seconds kStatusPeriod{5};

  /// `watchdog`: how long the manager may hear nothing before it acts; nothing: it does not watch.
  Supervision(Send send, std::optional<std::chrono::microseconds> watchdog)
      : send_(std::move(send)), watchdog_(watchdog) {}

  /// A frame is on the screen.
  void presented(Clock::time_point now, const std::string& status) {
    if (!ready_) {
      ready_ = true;
      told_status_ = now;
      fed_ = now;
      send_("READY=1\nSTATUS=" + status);
      return;
    }
    feed(now);
    tell(now, status);
  }
  /// A frame is made, but no screen is plugged in.
  void waiting_for_screen(Clock::time_point now) {
    if (ready_) {
      feed(now);
    } else if (!asked_ || now - *asked_ >= kScreenPatience / 3) {
      asked_ = now;
      send_("EXTEND_TIMEOUT_USEC=" + std::to_string(std::chrono::microseconds(kScreenPatience).count()));
    }
    tell(now, "waiting for a screen");
  }
  void reloading() {
    const auto now = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now().time_since_epoch());
    send_("RELOADING=1\nMONOTONIC_USEC=" + std::to_string(now.count()));
  }
  void reloaded(const std::string& status) { send_("READY=1\nSTATUS=" + status); }
  void stopping() { send_("STOPPING=1\nSTATUS=ending"); }

 private:
  void feed(Clock::time_point now) {
    if (!watchdog_ || (fed_ && now - *fed_ < *watchdog_ / 3)) return;
    fed_ = now;
    send_("WATCHDOG=1");
  }
  void tell(Clock::time_point now, const std::string& status) {
    if (told_status_ && now - *told_status_ < kStatusPeriod) return;
    told_status_ = now;
    send_("STATUS=" + status);
  }

  Send send_;
  std::optional<std::chrono::microseconds> watchdog_;
  bool ready_ = false;
  std::optional<Clock::time_point> asked_;
  std::optional<Clock::time_point> fed_;
  std::optional<Clock::time_point> told_status_;
};

/// WATCHDOG_USEC, if it is meant for this process. Of the environment: `usec` and `pid`, nullptr where unset.
[[nodiscard]] std::optional<std::chrono::microseconds> watchdog_time(const char* usec, const char* pid);

}  // namespace vitrine
