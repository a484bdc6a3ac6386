#include "fbdev_display.h"

#include "screen_choice.h"

namespace vitrine {
FbdevDisplay::FbdevDisplay(Extent picture, DisplayOptions options, bool insists)
    : options_(std::move(options)), frame_(picture) {
  find_device();
  if (!device_ && !insists) throw DisplayUnavailable(notice_);
}

DisplayMode FbdevDisplay::mode() const {
  const auto [width, height] = frame_.size();
  return {.width = width, .height = height};
}

void FbdevDisplay::find_device() {
  pace_.looked();
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
  frame_.fit({memory.width, memory.height}, options_.rotation);
  if (!console_) console_.emplace();
  scan_out_.emplace(frame_.size(), memory, options_.rotation, options_.scaling);
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
  if (pace_.look_is_due()) {
    pace_.looked();
    if (device_ && !device_->alive()) device_.reset();
    if (!device_) find_device();
  }
  if (waiting_for_screen()) return pace_.wait_a_frame();
  device_->await_vsync();
  scan_out_->copy(frame_.surface(), device_->pixels());
  pace_.presented();
}

}  // namespace vitrine
