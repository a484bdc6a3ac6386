// The display `drm`: a screen of a KMS card, drawn by the processor alone. The frame is drawn upright in
// cached memory and copied out when it is presented. A box outlives its screen: while none is plugged in, or
// the card itself is not there yet, the display waits, and sets the mode again when one comes.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "display.h"
#include "display_options.h"
#include "drm_screen.h"
#include "picture_frame.h"
#include "scan_out.h"
#include "screen_pace.h"
#include "udev_monitor.h"
#include "virtual_terminal.h"

namespace vitrine {

class DrmDisplay final : public Display {
 public:
  /// `picture`: the size to draw; without width or height that of the screen. When no card can be used now,
  /// waits for one if it `insists`, else throws DisplayUnavailable. Throws std::runtime_error for bad
  /// options.
  DrmDisplay(Extent picture, DisplayOptions options, bool insists);

  [[nodiscard]] DisplayMode mode() const override;
  Surface acquire() override { return frame_.surface(); }
  void present() override;
  [[nodiscard]] Surface shown() const override { return frame_.surface(); }
  [[nodiscard]] bool waiting_for_screen() const override { return !screen_ || !console_shown(); }

  /// What of the options could not be had when it was opened, or empty.
  [[nodiscard]] const std::string& notice() const { return notice_; }

 private:
  /// Lights the first screen that the options mean. Why there was none is in `notice_`.
  void find_screen();
  void light(DrmCard card, const DrmPipe& pipe);
  /// Follows what was plugged and unplugged.
  void watch_screen();
  /// Follows the switching of consoles.
  void serve_console();
  [[nodiscard]] bool console_shown() const { return !console_ || console_->shown(); }
  /// Copies the frame out; false when the screen is gone.
  [[nodiscard]] bool show();

  DisplayOptions options_;
  PictureFrame frame_;
  std::string notice_;
  bool card_seen_ = false;
  UdevMonitor monitor_{"drm"};
  ScreenPace pace_;
  std::optional<ScanOut> scan_out_;
  std::optional<VirtualTerminal> console_;
  std::unique_ptr<DrmScreen> screen_;  // closed before the console is given back
};

}  // namespace vitrine
