#include "fbdev_display.h"

#include <thread>

#include "screen_choice.h"

namespace vitrine {
namespace {

constexpr std::chrono::seconds kLookPeriod{1};
constexpr std::chrono::nanoseconds kWaitingFrame{1'000'000'000 / 60};
/// The picture while there has been no screen to take the size from.
constexpr Extent kUsualPicture{800, 480};

Extent size_of(const Surface& surface) { return {surface.width, surface.height}; }

}  // namespace

FbdevDisplay::FbdevDisplay(Extent picture, DisplayOptions options, bool insists)
    : picture_(picture.width > 0 && picture.height > 0 ? picture : Extent{}),
      options_(std::move(options)),
      frame_(picture_ == Extent{} ? kUsualPicture.width : picture_.width,
             picture_ == Extent{} ? kUsualPicture.height : picture_.height, PixelFormat::kXrgb8888) {
  find_device();
  if (!device_ && !insists) throw DisplayUnavailable(notice_);
}

DisplayMode FbdevDisplay::mode() const {
  const auto [width, height] = size_of(frame_.surface());
  return {.width = width, .height = height};
}

void FbdevDisplay::find_device() {
  next_look_ = Clock::now() + kLookPeriod;
  notice_.clear();
  std::string reasons;
  for (const FramebufferInfo& info : list_framebuffers().framebuffers) {
    if (!is_meant(info, options_.device)) continue;
    try {
      light(std::make_unique<FramebufferDevice>(info.path, options_.format));
      return;
    } catch (const DisplayUnavailable& error) {
      reasons += (reasons.empty() ? "" : ". ") + std::string(error.what());
    }
  }
  if (reasons.empty()) {
    reasons = options_.device.empty()
                  ? "no framebuffer device in /dev; load its driver"
                  : "no framebuffer device '" + options_.device + "'; 'vitrine probe' lists the devices";
  }
  notice_ = reasons;
}

void FbdevDisplay::light(std::unique_ptr<FramebufferDevice> device) {
  const ScreenMemory memory = device->memory();
  const Extent picture =
      picture_ == Extent{} ? turned({memory.width, memory.height}, options_.rotation) : picture_;
  if (picture != size_of(frame_.surface())) {
    frame_ = SurfaceMemory(picture.width, picture.height, PixelFormat::kXrgb8888);
  }
  if (!console_) console_.emplace();
  scan_out_.emplace(picture, memory, options_.rotation, options_.scaling);
  device_ = std::move(device);
  if (console_shown()) scan_out_->blacken(device_->pixels());
}

void FbdevDisplay::serve_console() {
  if (!console_) return;
  for (auto wish = console_->wish(); wish != VirtualTerminal::Wish::kNone; wish = console_->wish()) {
    if (wish == VirtualTerminal::Wish::kRelease) {
      console_->released();
    } else {
      console_->acquired();
      if (device_) scan_out_->blacken(device_->pixels());
    }
  }
}

void FbdevDisplay::present() {
  serve_console();
  if (Clock::now() >= next_look_) {
    next_look_ = Clock::now() + kLookPeriod;
    if (device_ && !device_->alive()) device_.reset();
    if (!device_) find_device();
  }
  if (waiting_for_screen()) {
    std::this_thread::sleep_until(presented_ + kWaitingFrame);
  } else {
    device_->await_vsync();
    scan_out_->copy(frame_.surface(), device_->pixels());
  }
  presented_ = Clock::now();
}

}  // namespace vitrine
