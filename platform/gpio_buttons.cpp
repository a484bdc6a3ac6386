#include "gpio_buttons.h"

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "device_access.h"
#include "readable.h"

namespace vitrine {
namespace {

constexpr std::chrono::seconds kLookPeriod{1};

/// Why a request failed, for a person who holds the wires.
std::string request_problem(const GpioPlace& place, const GpioInventory& inventory, int error) {
  const std::string line = place.chip.filename().string() + " line " + std::to_string(place.offset);
  if (error == EBUSY) {
    std::string consumer;
    for (const GpioChip& chip : inventory.chips) {
      if (chip.path == place.chip) consumer = chip.lines[place.offset].consumer;
    }
    return line + " is in use" + (consumer.empty() ? "" : " by '" + consumer + "'") +
           "; end that, or wire a free line ('vitrine probe' lists them)";
  }
  if (error == EACCES || error == EPERM) return open_problem(place.chip, error);
  return line + " cannot tell its edges: " + std::generic_category().message(error) +
         "; wire a line that can interrupt, and check its bias";
}

}  // namespace

std::unique_ptr<RequestedLine> take_line(const GpioLine& line, const GpioInventory& inventory) {
  const GpioPlace place = find_line(line, inventory);
  try {
    return request_line({.chip = place.chip,
                         .offset = place.offset,
                         .active_low = line.active_low,
                         .bias = line.bias,
                         .debounce = line.debounce});
  } catch (const std::system_error& error) {
    throw std::runtime_error("button '" + line.button +
                             "': " + request_problem(place, inventory, error.code().value()));
  }
}

GpioButtons::GpioButtons(std::span<const GpioLine> lines, Take take) : take_(std::move(take)) {
  for (const GpioLine& line : lines) contacts_.push_back({line, Debouncer(line.debounce)});
  look_for_lines();
}

std::vector<ButtonEvent> GpioButtons::poll(std::chrono::milliseconds timeout) {
  const Clock::time_point end = Clock::now() + timeout;
  std::vector<ButtonEvent> events;
  while (true) {
    if (Clock::now() >= next_look_) look_for_lines();
    for (Contact& contact : contacts_) {
      if (!contact.line) continue;
      try {
        read(contact, events);
      } catch (const std::system_error& error) {
        lose(contact, error.code().value(), events);
      }
    }
    if (!events.empty() || Clock::now() >= end) break;
    wait(end);
  }
  std::ranges::stable_sort(events, {}, &ButtonEvent::time);
  return events;
}

std::string GpioButtons::notice() const {
  std::string notice;
  for (const Contact& contact : contacts_) {
    if (!contact.line) notice += (notice.empty() ? "" : ". ") + contact.problem;
  }
  return notice;
}

void GpioButtons::look_for_lines() {
  next_look_ = Clock::now() + kLookPeriod;
  if (std::ranges::all_of(contacts_, [](const Contact& contact) { return contact.line != nullptr; })) return;
  const GpioInventory inventory = find_gpio_chips();
  for (Contact& contact : contacts_) {
    if (contact.line) continue;
    try {
      contact.line = take_(contact.wire, inventory);
      contact.debouncer = Debouncer(contact.line->debounced() ? Clock::duration{0} : contact.wire.debounce);
    } catch (const std::runtime_error& error) {
      contact.problem = error.what();
    }
  }
}

void GpioButtons::read(Contact& contact, std::vector<ButtonEvent>& events) {
  while (true) {
    while (readable_now(contact.line->descriptor())) {
      for (const LineEdge& edge : contact.line->edges())
        report(contact, contact.debouncer.edge(edge.active, edge.time), events);
    }
    const std::optional<Clock::time_point> rest = contact.debouncer.deadline();
    if (!rest || Clock::now() < *rest) return;
    const bool level = contact.line->active();
    // An edge that slipped in before the level was read may be what the level is about.
    if (readable_now(contact.line->descriptor())) continue;
    report(contact, contact.debouncer.settle(level), events);
    return;
  }
}

void GpioButtons::report(Contact& contact, std::optional<Debouncer::Change> change,
                         std::vector<ButtonEvent>& events) {
  if (!change) return;
  contact.pressed = change->active;
  events.push_back({contact.wire.button, change->active ? Edge::kPress : Edge::kRelease, change->time});
}

void GpioButtons::lose(Contact& contact, int error, std::vector<ButtonEvent>& events) {
  contact.line.reset();
  contact.problem = "button '" + contact.wire.button + "': its GPIO chip is gone (" +
                    std::generic_category().message(error) + "); plug it in again";
  if (std::exchange(contact.pressed, false))
    events.push_back({contact.wire.button, Edge::kRelease, Clock::now()});
}

void GpioButtons::wait(Clock::time_point until) const {
  std::vector<int> descriptors;
  for (const Contact& contact : contacts_) {
    if (!contact.line) {
      until = std::min(until, next_look_);
      continue;
    }
    descriptors.push_back(contact.line->descriptor());
    if (const auto rest = contact.debouncer.deadline()) until = std::min(until, *rest);
  }
  wait_readable(descriptors, until);
}

}  // namespace vitrine
