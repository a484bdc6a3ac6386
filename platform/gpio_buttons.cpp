#include "gpio_buttons.h"

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "device_access.h"
#include "gpio_places.h"
#include "readable.h"

namespace vitrine {
namespace {

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

void report(const std::string& button, std::optional<Debouncer::Change> change,
            std::vector<ButtonEvent>& events) {
  if (change) events.push_back({button, change->active ? Edge::kPress : Edge::kRelease, change->time});
}

}  // namespace

GpioButtons::GpioButtons(std::span<const GpioLine> lines) {
  const GpioInventory inventory = find_gpio_chips();
  for (const GpioLine& line : lines) {
    std::unique_ptr<RequestedLine> taken = take_line(line, inventory);
    const Debouncer debouncer(taken->debounced() ? Clock::duration{0} : line.debounce);
    contacts_.push_back({line.button, std::move(taken), debouncer});
  }
}

std::vector<ButtonEvent> GpioButtons::poll(std::chrono::milliseconds timeout) {
  const Clock::time_point end = Clock::now() + timeout;
  std::vector<ButtonEvent> events;
  while (true) {
    for (Contact& contact : contacts_) take(contact, events);
    if (!events.empty() || Clock::now() >= end) break;
    wait(end);
  }
  std::ranges::stable_sort(events, {}, &ButtonEvent::time);
  return events;
}

void GpioButtons::take(Contact& contact, std::vector<ButtonEvent>& events) {
  while (true) {
    while (readable_now(contact.line->descriptor())) {
      for (const LineEdge& edge : contact.line->edges())
        report(contact.button, contact.debouncer.edge(edge.active, edge.time), events);
    }
    const std::optional<Clock::time_point> rest = contact.debouncer.deadline();
    if (!rest || Clock::now() < *rest) return;
    const bool level = contact.line->active();
    // An edge that slipped in before the level was read may be what the level is about.
    if (readable_now(contact.line->descriptor())) continue;
    report(contact.button, contact.debouncer.settle(level), events);
    return;
  }
}

void GpioButtons::wait(Clock::time_point until) const {
  std::vector<int> descriptors;
  for (const Contact& contact : contacts_) {
    descriptors.push_back(contact.line->descriptor());
    if (const auto rest = contact.debouncer.deadline()) until = std::min(until, *rest);
  }
  wait_readable(descriptors, until);
}

}  // namespace vitrine
