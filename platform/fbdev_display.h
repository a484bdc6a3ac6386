// The display `fbdev`: a framebuffer device, which is what some small panels still are. One buffer, written
// while it is shown, after the vertical blank where the device tells it; prefer `drm` where both are.
#pragma once

#include <memory>
#include <optional>

#include "display.h"
#include "display_options.h"
#include "framebuffer_device.h"
#include "picture_frame.h"
#include "scan_out.h"
#include "screen_pace.h"
#include "virtual_terminal.h"

namespace vitrine {

class FbdevDisplay final : public Display {
 public:
  /// `picture`: the size to draw; without width or height that of the screen. When no device can be used now,
  /// waits for one if it `insists`, else throws DisplayUnavailable.
  FbdevDisplay(Extent picture, DisplayOptions options, bool insists);

  [[nodiscard]] DisplayMode mode() const override;
  Surface acquire() override { return frame_.surface(); }
  void present() override;
  [[nodiscard]] Surface shown() const override { return frame_.surface(); }
  [[nodiscard]] bool waiting_for_screen() const override { return !device_ || !console_shown(); }

  /// Why it waits since it was opened, or empty.
  [[nodiscard]] const std::string& notice() const { return notice_; }

 private:
  void find_device();
  void light(std::unique_ptr<FramebufferDevice> device);
  void serve_console();
  [[nodiscard]] bool console_shown() const { return !console_ || console_->shown(); }

  DisplayOptions options_;
  PictureFrame frame_;
  std::string notice_;
  ScreenPace pace_;
  std::optional<ScanOut> scan_out_;
  std::optional<VirtualTerminal> console_;
  std::unique_ptr<FramebufferDevice> device_;
};

}  // namespace vitrine
