// The two libraries that read GPIO lines, libgpiod 1 and libgpiod 2, behind the little that a button needs of
// them. gpio_lines_v1.cpp or gpio_lines_v2.cpp implements this; the build takes the one whose library is
// there.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "button_wiring.h"
#include "buttons.h"

namespace vitrine {

struct GpioLineInfo {
  unsigned offset = 0;
  std::string name{};      ///< empty: the device tree gives none
  std::string consumer{};  ///< who has it, where that is told
  bool used = false;       ///< by somebody else: it cannot be requested
  bool output = false;
};

struct GpioChip {
  std::filesystem::path path;  ///< /dev/gpiochip0
  std::string name;            ///< "gpiochip0"
  std::string label;           ///< "pinctrl-bcm2711"
  std::vector<GpioLineInfo> lines;
};

/// Throws std::system_error.
[[nodiscard]] GpioChip read_gpio_chip(const std::filesystem::path& path);

struct LineRequest {
  std::filesystem::path chip;
  unsigned offset = 0;
  bool active_low = false;
  Bias bias = Bias::kAsIs;
  std::chrono::milliseconds debounce{0};
};

struct LineEdge {
  bool active;  ///< the level after it; logical, under active_low
  Clock::time_point time;
};

/// A line that is ours until the end of this object. What fails later than the request throws
/// std::system_error.
class RequestedLine {
 public:
  virtual ~RequestedLine() = default;
  RequestedLine(const RequestedLine&) = delete;
  RequestedLine& operator=(const RequestedLine&) = delete;

  /// Readable when an edge waits.
  [[nodiscard]] virtual int descriptor() const = 0;
  /// Some edges that wait, at least one; call when the descriptor is readable.
  virtual std::vector<LineEdge> edges() = 0;
  /// The level now.
  virtual bool active() = 0;
  /// Whether the kernel debounces: edges come clean.
  [[nodiscard]] virtual bool debounced() const = 0;

 protected:
  RequestedLine() = default;
};

/// Throws std::system_error; its code is EBUSY for a line that is in use.
[[nodiscard]] std::unique_ptr<RequestedLine> request_line(const LineRequest& request);

}  // namespace vitrine
