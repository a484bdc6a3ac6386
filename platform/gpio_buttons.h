// Buttons on GPIO lines. Each line has edges with the kernel's times and is debounced, by the kernel where
// libgpiod can ask for that and by us where not.
//
// A line that is not there yet, or not any more, is waited for, and the other buttons work meanwhile: drivers
// are loaded late, expanders are unplugged, and a box with one loose wire is still a box.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "button_wiring.h"
#include "buttons.h"
#include "debounce.h"
#include "gpio_lines.h"
#include "gpio_places.h"

namespace vitrine {

/// Requests the line of this machine's chips that the configuration means. Throws std::runtime_error, one
/// line that says which button, why not, and what to do.
[[nodiscard]] std::unique_ptr<RequestedLine> take_line(const GpioLine& line, const GpioInventory& inventory);

class GpioButtons final : public Buttons {
 public:
  using Take = std::function<std::unique_ptr<RequestedLine>(const GpioLine&, const GpioInventory&)>;

  explicit GpioButtons(std::span<const GpioLine> lines, Take take = take_line);

  std::vector<ButtonEvent> poll(std::chrono::milliseconds timeout) override;

  /// Which lines are waited for, and why.
  [[nodiscard]] std::string notice() const override;

 private:
  struct Contact {
    GpioLine wire;
    Debouncer debouncer;
    std::unique_ptr<RequestedLine> line{};  ///< none: waited for
    std::string problem{};                  ///< why
    bool pressed = false;                   ///< as it was told
  };

  void look_for_lines();
  /// What a line has to tell now. Throws std::system_error when its chip is gone.
  static void read(Contact& contact, std::vector<ButtonEvent>& events);
  static void report(Contact& contact, std::optional<Debouncer::Change> change,
                     std::vector<ButtonEvent>& events);
  /// The chip of a line has gone away: what was held is released.
  static void lose(Contact& contact, int error, std::vector<ButtonEvent>& events);
  /// Until an edge waits, a contact may have come to rest, or the time is over.
  void wait(Clock::time_point until) const;

  Take take_;
  std::vector<Contact> contacts_;
  Clock::time_point next_look_{};
};

}  // namespace vitrine
