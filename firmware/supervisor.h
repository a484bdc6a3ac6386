// Who watches over a running box: tells the service manager about each frame, reads the temperature and slows
// the tracer down when it must, and writes the box's health into a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "health_file.h"
#include "supervision.h"
#include "supervision_config.h"
#include "thermal_governor.h"

namespace vitrine {

/// What there is to say about a frame that was presented.
struct FrameNews {
  Clock::time_point time;
  std::string scene;
  std::string mode;
  double frames_per_second = 0.0;
  bool traced = false;  ///< the tracer was at work
  bool failing = false;
  bool waiting_for_screen = false;
  std::string buttons_notice{};  ///< which buttons are waited for, and why
  std::uint64_t presses = 0;
  double slowest_press_s = 0.0;
};

class Supervisor {
 public:
  /// The temperature is read this often.
  static constexpr std::chrono::seconds kThermalPeriod{2};

  struct Settings {
    GovernorSettings governor{};
    HealthSettings health{};
    std::optional<std::filesystem::path> runtime_folder{};  ///< where the health file lies by default
  };

  Supervisor(Settings settings, Supervision supervision);

  void refit(const Settings& settings);
  /// Called after each frame.
  void presented(const FrameNews& news);
  [[nodiscard]] Supervision& manager() { return supervision_; }

  /// The part of its time that the tracer may work.
  [[nodiscard]] double duty() const { return governor_.duty(); }
  /// Why that is not all of it; empty when it is.
  [[nodiscard]] std::string governor_line() const;

 private:
  void write_health();
  /// Into the journal, whenever it changes.
  void tell_of_buttons(const std::string& notice);

  Settings settings_;
  Supervision supervision_;
  ThermalGovernor governor_;
  std::optional<std::filesystem::path> thermal_zone_;
  std::optional<std::filesystem::path> health_file_;
  Health health_;
  std::optional<Clock::time_point> began_;
  std::optional<Clock::time_point> frame_before_;
  std::optional<Clock::time_point> read_thermals_;
  std::optional<Clock::time_point> wrote_health_;
  bool write_failed_ = false;  ///< told once
  std::string buttons_notice_;
};

}  // namespace vitrine
