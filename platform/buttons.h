// The seam to the buttons. Backends report edges of named buttons; what a button does is the firmware's
// business.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace vitrine {

using Clock = std::chrono::steady_clock;

/// Where time comes from: the machine's clock, or a script's synthetic one.
class TimeSource {
 public:
  virtual ~TimeSource() = default;
  [[nodiscard]] virtual Clock::time_point now() const = 0;
};

/// A button of the box: its name ("scene"), the caption a simulated box shows, and its key in the simulation.
struct ButtonSpec {
  std::string name;
  std::string caption;
  std::string key;  ///< an SDL key name: "S", "Right", "Escape"; empty: no key
};

enum class Edge : std::uint8_t { kPress, kRelease };

struct ButtonEvent {
  std::string button;  ///< ButtonSpec::name
  Edge edge = Edge::kPress;
  Clock::time_point time;
};

/// A source of button events. Used from one thread.
class Buttons {
 public:
  virtual ~Buttons() = default;
  Buttons(const Buttons&) = delete;
  Buttons& operator=(const Buttons&) = delete;

  /// The events since the last call, oldest first; waits at most `timeout` for the first one.
  virtual std::vector<ButtonEvent> poll(std::chrono::milliseconds timeout) = 0;

  /// One line to tell the user now, or empty: what is missing or waited for.
  [[nodiscard]] virtual std::string notice() const { return {}; }

 protected:
  Buttons() = default;
};

}  // namespace vitrine
