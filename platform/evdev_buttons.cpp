#include "evdev_buttons.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <system_error>
#include <utility>

#include <libevdev/libevdev.h>
#include <sys/stat.h>

#include "device_access.h"
#include "readable.h"

namespace vitrine {
namespace {

constexpr std::chrono::seconds kLookPeriod{1};
/// One event of an axis may carry several steps; a wheel that was spun must not keep the box busy.
constexpr int kMostSteps = 16;

Clock::time_point time_of(const input_event& event) {
  const auto since_boot =
      std::chrono::seconds(event.input_event_sec) + std::chrono::microseconds(event.input_event_usec);
  return std::min(Clock::time_point(since_boot), Clock::now());
}

}  // namespace

EvdevButtons::EvdevButtons(std::span<const EvdevDevice> devices, std::span<const ButtonSpec> buttons,
                           std::filesystem::path folder)
    : folder_(std::move(folder)) {
  const std::vector<EvdevDevice> every{{}};
  for (const EvdevDevice& device : devices.empty() ? std::span(every) : devices)
    wanted_.push_back({device, device.keys.empty() ? input_map(buttons) : input_map(device)});
  look_for_devices();
}

std::vector<ButtonEvent> EvdevButtons::poll(std::chrono::milliseconds timeout) {
  const Clock::time_point end = Clock::now() + timeout;
  std::vector<ButtonEvent> events;
  while (true) {
    if (Clock::now() >= next_look_) look_for_devices();
    std::erase_if(sources_, [&](Source& source) {
      if (read(source, events)) return false;
      release_all(source, events);
      known_.erase(source.node);
      return true;
    });
    if (!events.empty() || Clock::now() >= end) break;
    std::vector<int> descriptors;
    for (const Source& source : sources_) descriptors.push_back(source.handle.descriptor());
    wait_readable(descriptors, std::min(end, next_look_));
  }
  std::ranges::stable_sort(events, {}, &ButtonEvent::time);
  return events;
}

std::string EvdevButtons::notice() const {
  std::string notice;
  const auto add = [&](const std::string& line) { notice += (notice.empty() ? "" : ". ") + line; };
  for (const Wanted& wanted : wanted_) {
    const bool open =
        std::ranges::any_of(sources_, [&](const Source& source) { return source.wanted == &wanted; });
    if (!open && !wanted.device.name.empty())
      add("waiting for the input device '" + wanted.device.name + "' ('vitrine probe' lists what is there)");
  }
  for (const auto& [node, problem] : problems_) add(problem);
  return notice;
}

void EvdevButtons::look_for_devices() {
  next_look_ = Clock::now() + kLookPeriod;
  const std::vector<std::filesystem::path> nodes = input_nodes(folder_);
  const auto gone = [&](const auto& entry) { return std::ranges::find(nodes, entry.first) == nodes.end(); };
  std::erase_if(known_, gone);
  std::erase_if(problems_, gone);
  for (const std::filesystem::path& node : nodes) {
    if (std::ranges::find(sources_, node, &Source::node) != sources_.end()) continue;
    struct stat status {};
    if (stat(node.c_str(), &status) != 0) continue;
    const Identity identity{status.st_ino, status.st_ctim};
    const auto known = known_.find(node);
    // A link may come later than its node.
    if (known != known_.end() && known->second == identity && !named_by_path(node)) continue;
    known_.insert_or_assign(node, identity);
    consider(node);
  }
}

void EvdevButtons::consider(const std::filesystem::path& node) {
  problems_.erase(node);
  try {
    InputHandle handle(node);
    const Wanted* const wanted = wanted_as(handle.describe());
    if (wanted == nullptr) return;
    libevdev_set_clock_id(handle.get(), CLOCK_MONOTONIC);
    if (wanted->device.grab && libevdev_grab(handle.get(), LIBEVDEV_GRAB) != 0)
      problems_[node] = node.string() + ": another program has grabbed it; end that";
    sources_.push_back({node, std::move(handle), wanted, {}});
  } catch (const std::system_error& error) {
    problems_[node] = open_problem(node, error.code().value());
  }
}

bool EvdevButtons::named_by_path(const std::filesystem::path& node) const {
  return std::ranges::any_of(wanted_, [&](const Wanted& wanted) {
    std::error_code missing;
    return wanted.device.name.starts_with('/') &&
           std::filesystem::equivalent(wanted.device.name, node, missing);
  });
}

const EvdevButtons::Wanted* EvdevButtons::wanted_as(const InputDevice& device) const {
  const auto found = std::ranges::find_if(wanted_, [&](const Wanted& wanted) {
    const std::string& name = wanted.device.name;
    if (name.empty()) return why_unused(device, wanted.map).empty();
    std::error_code missing;
    return name == device.name ||
           (name.starts_with('/') && std::filesystem::equivalent(name, device.node, missing));
  });
  return found == wanted_.end() ? nullptr : &*found;
}

bool EvdevButtons::read(Source& source, std::vector<ButtonEvent>& events) {
  unsigned flag = LIBEVDEV_READ_FLAG_NORMAL;
  while (true) {
    input_event event{};
    const int status = libevdev_next_event(source.handle.get(), flag, &event);
    if (status == LIBEVDEV_READ_STATUS_SUCCESS || status == LIBEVDEV_READ_STATUS_SYNC) {
      // After a drop, libevdev tells as events in what the keys differ from what it told before.
      if (status == LIBEVDEV_READ_STATUS_SYNC) flag = LIBEVDEV_READ_FLAG_SYNC;
      if (event.type == EV_KEY) take(source, {EV_KEY, event.code, 0}, event.value, time_of(event), events);
      if (event.type == EV_REL)
        take(source, {EV_REL, event.code, event.value > 0 ? 1 : -1}, event.value, time_of(event), events);
    } else if (status == -EAGAIN && flag == LIBEVDEV_READ_FLAG_SYNC) {
      flag = LIBEVDEV_READ_FLAG_NORMAL;
    } else {
      return status == -EAGAIN || status == -EINTR;
    }
  }
}

void EvdevButtons::take(Source& source, const InputCode& code, int value, Clock::time_point time,
                        std::vector<ButtonEvent>& events) {
  const auto mapped = source.wanted->map.find(code);
  if (mapped == source.wanted->map.end()) return;
  const std::string& button = mapped->second;
  if (code.type == EV_REL) {
    for (int step = std::min(std::abs(value), kMostSteps); step > 0; --step) {
      events.push_back({button, Edge::kPress, time});
      events.push_back({button, Edge::kRelease, time});
    }
  } else if (value == 1 && source.held.insert(code).second) {
    events.push_back({button, Edge::kPress, time});
  } else if (value == 0 && source.held.erase(code) > 0) {
    events.push_back({button, Edge::kRelease, time});
  }
}

void EvdevButtons::release_all(Source& source, std::vector<ButtonEvent>& events) {
  for (const InputCode& code : std::exchange(source.held, {}))
    events.push_back({source.wanted->map.at(code), Edge::kRelease, Clock::now()});
}

}  // namespace vitrine
