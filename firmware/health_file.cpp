#include "health_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include <unistd.h>

namespace vitrine {
namespace {

/// As the format wants label values.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '\n') {
      result += "\\n";
    } else {
      if (letter == '\\' || letter == '"') result += '\\';
      result += letter;
    }
  }
  return result;
}

class Exposition {
 public:
  Exposition() { text_ << std::setprecision(12); }

  /// The head of a metric; its samples follow.
  void metric(const std::string& name, const char* type, const char* help) {
    text_ << "# HELP " << name << ' ' << help << "\n# TYPE " << name << ' ' << type << '\n';
  }
  template <class Value>
  void sample(const std::string& name, const Value& value) {
    text_ << name << ' ' << value << '\n';
  }
  template <class Value>
  void single(const std::string& name, const char* type, const char* help, const Value& value) {
    metric(name, type, help);
    sample(name, value);
  }
  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

void write_frame_times(Exposition& out, const FrameTimes& times) {
  const std::string name = "vitrine_frame_seconds";
  out.metric(name, "histogram", "Time from one presented frame to the next, while the tracer works.");
  for (std::size_t i = 0; i < FrameTimes::kBounds_s.size(); ++i) {
    std::ostringstream bound;
    bound << FrameTimes::kBounds_s[i];
    out.sample(name + "_bucket{le=\"" + bound.str() + "\"}", times.at_most(i));
  }
  out.sample(name + "_bucket{le=\"+Inf\"}", times.count());
  out.sample(name + "_sum", times.sum().count());
  out.sample(name + "_count", times.count());
  out.metric("vitrine_recent_frame_seconds", "gauge", "The same, of the latest 1000 frames.");
  out.sample("vitrine_recent_frame_seconds{quantile=\"0.5\"}", times.quantile(0.5).count());
  out.sample("vitrine_recent_frame_seconds{quantile=\"0.99\"}", times.quantile(0.99).count());
}

}  // namespace

std::string prometheus_text(const Health& health) {
  Exposition out;
  out.single("vitrine_frames_total", "counter", "Presented frames.", health.frames);
  write_frame_times(out, health.frame_times);
  if (health.thermals.temperature_c) {
    out.single("vitrine_temperature_celsius", "gauge", "Of the processor.", *health.thermals.temperature_c);
  }
  if (health.thermals.throttled) {
    out.single("vitrine_throttled", "gauge", "1: the machine has slowed itself down.",
               *health.thermals.throttled ? 1 : 0);
  }
  out.single("vitrine_duty_ratio", "gauge", "The part of its time that the tracer may work.", health.duty);
  out.metric("vitrine_showing", "gauge", "What is on show.");
  out.sample("vitrine_showing{scene=\"" + escaped(health.scene) + "\",mode=\"" + escaped(health.mode) + "\"}",
             1);
  out.single("vitrine_failing", "gauge", "1: an error card is on show.", health.failing ? 1 : 0);
  out.single("vitrine_waiting_for_screen", "gauge", "1: no screen is plugged in.",
             health.waiting_for_screen ? 1 : 0);
  out.single("vitrine_waiting_for_buttons", "gauge", "1: a button or an input device is missing.",
             health.waiting_for_buttons ? 1 : 0);
  out.single("vitrine_presses_total", "counter", "Presses of buttons.", health.presses);
  out.single("vitrine_slowest_press_seconds", "gauge", "The longest time from a press to its label.",
             health.slowest_press_s);
  out.single("vitrine_resident_memory_bytes", "gauge", "Resident memory.", health.resident_bytes);
  out.single("vitrine_uptime_seconds", "counter", "Since the program began.", health.uptime_s);
  return out.text();
}

void replace_file(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path fresh = file.string() + ".new";
  const auto fail = [](const std::filesystem::path& which) {
    throw std::runtime_error(which.string() + ": " + std::strerror(errno) +
                             "; name a file that can be written");
  };
  errno = 0;
  if (!(std::ofstream(fresh) << text << std::flush)) fail(fresh);
  if (std::rename(fresh.c_str(), file.c_str()) != 0) fail(file);
}

std::uint64_t resident_bytes() {
  std::ifstream stream("/proc/self/statm");
  std::uint64_t total = 0;
  std::uint64_t resident = 0;
  if (!(stream >> total >> resident)) return 0;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace vitrine
