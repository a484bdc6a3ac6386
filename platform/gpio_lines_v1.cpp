// gpio_lines.h on libgpiod 1 (Debian bookworm), which knows no debounce.
#include <algorithm>
#include <array>
#include <cerrno>
#include <span>
#include <system_error>

#include <gpiod.h>

#include "gpio_lines.h"

namespace vitrine {
namespace {

struct ChipCloser {
  void operator()(gpiod_chip* chip) const { gpiod_chip_close(chip); }  // releases its lines, too
};
using Chip = std::unique_ptr<gpiod_chip, ChipCloser>;

[[noreturn]] void fail(const std::filesystem::path& chip) {
  throw std::system_error(errno, std::generic_category(), chip.string());
}

Chip open_chip(const std::filesystem::path& path) {
  Chip chip(gpiod_chip_open(path.c_str()));
  if (!chip) fail(path);
  return chip;
}

gpiod_line* get_line(gpiod_chip* chip, const std::filesystem::path& path, unsigned offset) {
  gpiod_line* const line = gpiod_chip_get_line(chip, offset);
  if (line == nullptr) fail(path);
  return line;
}

std::string text(const char* words) { return words == nullptr ? "" : words; }

int bias_flag(Bias bias) {
  switch (bias) {
    case Bias::kAsIs:
      break;
    case Bias::kPullUp:
      return GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP;
    case Bias::kPullDown:
      return GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN;
    case Bias::kDisabled:
      return GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE;
  }
  return 0;
}

class LineV1 final : public RequestedLine {
 public:
  explicit LineV1(const LineRequest& request)
      : path_(request.chip), chip_(open_chip(path_)), line_(get_line(chip_.get(), path_, request.offset)) {
    const gpiod_line_request_config config{
        .consumer = "vitrine",
        .request_type = GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES,
        .flags = bias_flag(request.bias) | (request.active_low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0)};
    if (gpiod_line_request(line_, &config, 0) != 0) fail(path_);
  }

  [[nodiscard]] int descriptor() const override { return gpiod_line_event_get_fd(line_); }

  std::vector<LineEdge> edges() override {
    std::array<gpiod_line_event, 16> events{};  // as many as the kernel keeps
    const int count = gpiod_line_event_read_multiple(line_, events.data(), events.size());
    if (count < 0) fail(path_);
    // Kernels before 5.7 tell the wall clock's time, which lies after this.
    const Clock::time_point now = Clock::now();
    std::vector<LineEdge> edges;
    for (const gpiod_line_event& event : std::span(events).first(static_cast<std::size_t>(count))) {
      const auto since_boot =
          std::chrono::seconds(event.ts.tv_sec) + std::chrono::nanoseconds(event.ts.tv_nsec);
      edges.push_back(
          {event.event_type == GPIOD_LINE_EVENT_RISING_EDGE, std::min(now, Clock::time_point(since_boot))});
    }
    return edges;
  }

  bool active() override {
    const int level = gpiod_line_get_value(line_);
    if (level < 0) fail(path_);
    return level == 1;
  }

  [[nodiscard]] bool debounced() const override { return false; }

 private:
  std::filesystem::path path_;
  Chip chip_;
  gpiod_line* line_;
};

}  // namespace

GpioChip read_gpio_chip(const std::filesystem::path& path) {
  const Chip chip = open_chip(path);
  GpioChip result{path, text(gpiod_chip_name(chip.get())), text(gpiod_chip_label(chip.get())), {}};
  for (unsigned offset = 0; offset < gpiod_chip_num_lines(chip.get()); ++offset) {
    gpiod_line* const line = get_line(chip.get(), path, offset);
    result.lines.push_back({offset, text(gpiod_line_name(line)), text(gpiod_line_consumer(line)),
                            gpiod_line_is_used(line),
                            gpiod_line_direction(line) == GPIOD_LINE_DIRECTION_OUTPUT});
  }
  return result;
}

std::unique_ptr<RequestedLine> request_line(const LineRequest& request) {
  return std::make_unique<LineV1>(request);
}

}  // namespace vitrine
