#include "supervisor.h"

#include <cstdio>
#include <exception>
#include <iostream>
#include <utility>

#include "thermal_sensor.h"

namespace vitrine {
namespace {

bool due(const std::optional<Clock::time_point>& last, Clock::time_point now, Clock::duration period) {
  return !last || now - *last >= period;
}

std::string status_line(const FrameNews& news, const std::string& governor) {
  char rate[32];
  std::snprintf(rate, sizeof rate, ", %.1f fps", news.frames_per_second);
  return (news.failing ? "an error card over " : "") + news.scene + ", " + news.mode +
         (news.frames_per_second > 0.0 ? rate : "") + (governor.empty() ? "" : ", " + governor) +
         (news.buttons_notice.empty() ? "" : "; " + news.buttons_notice);
}

}  // namespace

Supervisor::Supervisor(Settings settings, Supervision supervision)
    : settings_(std::move(settings)),
      supervision_(std::move(supervision)),
      governor_(settings_.governor.limits) {
  refit(settings_);
}

void Supervisor::refit(const Settings& settings) {
  if (settings.governor.limits != settings_.governor.limits)
    governor_ = ThermalGovernor(settings.governor.limits);
  settings_ = settings;
  thermal_zone_ = settings_.governor.thermal ? settings_.governor.thermal : find_thermal_zone();
  health_file_ = settings_.health.file;
  if (!health_file_ && settings_.runtime_folder) health_file_ = *settings_.runtime_folder / "vitrine.prom";
  read_thermals_.reset();
  wrote_health_.reset();
  write_failed_ = false;
}

void Supervisor::presented(const FrameNews& news) {
  if (!began_) began_ = news.time;
  ++health_.frames;
  if (news.traced && frame_before_) health_.frame_times.add(news.time - *frame_before_);
  frame_before_ = news.time;
  tell_of_buttons(news.buttons_notice);
  if (due(read_thermals_, news.time, kThermalPeriod)) {
    read_thermals_ = news.time;
    health_.thermals = read_thermals(thermal_zone_, settings_.governor.throttled);
    governor_.take(health_.thermals, news.time);
  }
  if (news.waiting_for_screen) {
    supervision_.waiting_for_screen(news.time);
  } else {
    supervision_.presented(news.time, status_line(news, governor_line()));
  }
  if (health_file_ && due(wrote_health_, news.time, settings_.health.every)) {
    wrote_health_ = news.time;
    health_.duty = duty();
    health_.scene = news.scene;
    health_.mode = news.mode;
    health_.failing = news.failing;
    health_.waiting_for_screen = news.waiting_for_screen;
    health_.waiting_for_buttons = !news.buttons_notice.empty();
    health_.presses = news.presses;
    health_.slowest_press_s = news.slowest_press_s;
    health_.resident_bytes = resident_bytes();
    health_.uptime_s = std::chrono::duration<double>(news.time - *began_).count();
    write_health();
  }
}

void Supervisor::write_health() {
  try {
    replace_file(*health_file_, prometheus_text(health_));
  } catch (const std::exception& error) {
    if (!std::exchange(write_failed_, true)) std::cerr << "vitrine: " << error.what() << '\n';
  }
}

void Supervisor::tell_of_buttons(const std::string& notice) {
  if (notice == buttons_notice_) return;
  buttons_notice_ = notice;
  if (!notice.empty()) std::cerr << "vitrine: " << notice << '\n';
}

std::string Supervisor::governor_line() const {
  if (governor_.step() == 0) return "";
  return "hot: 1/" + std::to_string(1 << governor_.step()) + " speed";
}

}  // namespace vitrine
