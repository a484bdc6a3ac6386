// The box's health for those who watch over many boxes: a file in Prometheus' text format, as its node
// exporter collects them from a folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "frame_times.h"
#include "thermal_governor.h"

namespace vitrine {

struct Health {
  std::uint64_t frames = 0;
  FrameTimes frame_times;  ///< of frames in whose time the tracer worked
  ThermalReading thermals;
  double duty = 1.0;  ///< the part of its time that the tracer may work
  std::string scene;
  std::string mode;
  bool failing = false;  ///< an error card is on show
  bool waiting_for_screen = false;
  bool waiting_for_buttons = false;  ///< one of the config is not there
  std::uint64_t presses = 0;
  double slowest_press_s = 0.0;
  std::uint64_t resident_bytes = 0;
  double uptime_s = 0.0;
};

/// The file's content. What is not known is left out.
[[nodiscard]] std::string prometheus_text(const Health& health);

/// Puts `text` in the place of `file` in one step, so that nobody ever reads half of it. Throws
/// std::runtime_error.
void replace_file(const std::filesystem::path& file, const std::string& text);

/// The memory that this process holds now; 0 when the system does not tell.
[[nodiscard]] std::uint64_t resident_bytes();

}  // namespace vitrine
