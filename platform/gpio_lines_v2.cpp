// gpio_lines.h on libgpiod 2 (Debian trixie), which has the kernel debounce.
#include <algorithm>
#include <cerrno>
#include <system_error>

#include <gpiod.h>

#include "gpio_lines.h"

namespace vitrine {
namespace {

constexpr std::size_t kEventsAtOnce = 64;

template <auto free>
struct Freer {
  template <class T>
  void operator()(T* pointer) const {
    free(pointer);
  }
};
template <class T, auto free>
using Owned = std::unique_ptr<T, Freer<free>>;

using Chip = Owned<gpiod_chip, gpiod_chip_close>;
using ChipInfo = Owned<gpiod_chip_info, gpiod_chip_info_free>;
using LineInfo = Owned<gpiod_line_info, gpiod_line_info_free>;
using LineSettings = Owned<gpiod_line_settings, gpiod_line_settings_free>;
using LineConfig = Owned<gpiod_line_config, gpiod_line_config_free>;
using RequestConfig = Owned<gpiod_request_config, gpiod_request_config_free>;
using Request = Owned<gpiod_line_request, gpiod_line_request_release>;
using EventBuffer = Owned<gpiod_edge_event_buffer, gpiod_edge_event_buffer_free>;

[[noreturn]] void fail(const std::filesystem::path& chip) {
  throw std::system_error(errno, std::generic_category(), chip.string());
}

/// What a call gave, if it gave something.
template <class Handle>
Handle require(const std::filesystem::path& chip, Handle handle) {
  if (!handle) fail(chip);
  return handle;
}

Chip open_chip(const std::filesystem::path& path) {
  return require(path, Chip(gpiod_chip_open(path.c_str())));
}

std::string text(const char* words) { return words == nullptr ? "" : words; }

gpiod_line_bias bias_setting(Bias bias) {
  switch (bias) {
    case Bias::kAsIs:
      break;
    case Bias::kPullUp:
      return GPIOD_LINE_BIAS_PULL_UP;
    case Bias::kPullDown:
      return GPIOD_LINE_BIAS_PULL_DOWN;
    case Bias::kDisabled:
      return GPIOD_LINE_BIAS_DISABLED;
  }
  return GPIOD_LINE_BIAS_AS_IS;
}

Request request_edges(const LineRequest& wanted) {
  const std::filesystem::path& path = wanted.chip;
  const auto settings = require(path, LineSettings(gpiod_line_settings_new()));
  gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_INPUT);
  gpiod_line_settings_set_edge_detection(settings.get(), GPIOD_LINE_EDGE_BOTH);
  gpiod_line_settings_set_bias(settings.get(), bias_setting(wanted.bias));
  gpiod_line_settings_set_active_low(settings.get(), wanted.active_low);
  gpiod_line_settings_set_event_clock(settings.get(), GPIOD_LINE_CLOCK_MONOTONIC);
  const auto debounce = std::chrono::duration_cast<std::chrono::microseconds>(wanted.debounce);
  gpiod_line_settings_set_debounce_period_us(settings.get(), static_cast<unsigned long>(debounce.count()));

  const auto lines = require(path, LineConfig(gpiod_line_config_new()));
  if (gpiod_line_config_add_line_settings(lines.get(), &wanted.offset, 1, settings.get()) != 0) fail(path);
  const auto config = require(path, RequestConfig(gpiod_request_config_new()));
  gpiod_request_config_set_consumer(config.get(), "vitrine");
  return require(path, Request(gpiod_chip_request_lines(open_chip(path).get(), config.get(), lines.get())));
}

class LineV2 final : public RequestedLine {
 public:
  explicit LineV2(const LineRequest& request)
      : path_(request.chip),
        offset_(request.offset),
        debounced_(request.debounce > std::chrono::milliseconds{0}),
        request_(request_edges(request)),
        events_(require(path_, EventBuffer(gpiod_edge_event_buffer_new(kEventsAtOnce)))) {}

  [[nodiscard]] int descriptor() const override { return gpiod_line_request_get_fd(request_.get()); }

  std::vector<LineEdge> edges() override {
    const int count = gpiod_line_request_read_edge_events(request_.get(), events_.get(), kEventsAtOnce);
    if (count < 0) fail(path_);
    const Clock::time_point now = Clock::now();
    std::vector<LineEdge> edges;
    for (int i = 0; i < count; ++i) {
      gpiod_edge_event* const event =
          gpiod_edge_event_buffer_get_event(events_.get(), static_cast<unsigned long>(i));
      const std::chrono::nanoseconds since_boot(gpiod_edge_event_get_timestamp_ns(event));
      edges.push_back({gpiod_edge_event_get_event_type(event) == GPIOD_EDGE_EVENT_RISING_EDGE,
                       std::min(now, Clock::time_point(since_boot))});
    }
    return edges;
  }

  bool active() override {
    const gpiod_line_value level = gpiod_line_request_get_value(request_.get(), offset_);
    if (level == GPIOD_LINE_VALUE_ERROR) fail(path_);
    return level == GPIOD_LINE_VALUE_ACTIVE;
  }

  [[nodiscard]] bool debounced() const override { return debounced_; }

 private:
  std::filesystem::path path_;
  unsigned offset_;
  bool debounced_;
  Request request_;
  EventBuffer events_;
};

}  // namespace

GpioChip read_gpio_chip(const std::filesystem::path& path) {
  const Chip chip = open_chip(path);
  const auto info = require(path, ChipInfo(gpiod_chip_get_info(chip.get())));
  GpioChip result{
      path, text(gpiod_chip_info_get_name(info.get())), text(gpiod_chip_info_get_label(info.get())), {}};
  for (unsigned offset = 0; offset < gpiod_chip_info_get_num_lines(info.get()); ++offset) {
    const auto line = require(path, LineInfo(gpiod_chip_get_line_info(chip.get(), offset)));
    result.lines.push_back({offset, text(gpiod_line_info_get_name(line.get())),
                            text(gpiod_line_info_get_consumer(line.get())),
                            gpiod_line_info_is_used(line.get()),
                            gpiod_line_info_get_direction(line.get()) == GPIOD_LINE_DIRECTION_OUTPUT});
  }
  return result;
}

std::unique_ptr<RequestedLine> request_line(const LineRequest& request) {
  return std::make_unique<LineV2>(request);
}

}  // namespace vitrine
