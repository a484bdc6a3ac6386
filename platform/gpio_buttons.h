// Buttons on GPIO lines. Each line has edges with the kernel's times and is debounced, by the kernel where
// libgpiod can ask for that and by us where not.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "button_wiring.h"
#include "buttons.h"
#include "debounce.h"
#include "gpio_lines.h"

namespace vitrine {

class GpioButtons final : public Buttons {
 public:
  /// Takes the lines. Throws std::runtime_error, one line that says which button, why, and what to do.
  explicit GpioButtons(std::span<const GpioLine> lines);

  /// Throws std::system_error when a chip is gone.
  std::vector<ButtonEvent> poll(std::chrono::milliseconds timeout) override;

 private:
  struct Contact {
    std::string button;
    std::unique_ptr<RequestedLine> line;
    Debouncer debouncer;
  };

  /// What a line has to tell now.
  static void take(Contact& contact, std::vector<ButtonEvent>& events);
  /// Until an edge waits, a contact may have come to rest, or the time is over.
  void wait(Clock::time_point until) const;

  std::vector<Contact> contacts_;
};

}  // namespace vitrine
