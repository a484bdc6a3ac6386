// A framebuffer device of the kernel: /dev/fbN, mapped for writing. Where it lies in memory and which bits
// are which colour is the device's to say; here it is believed, whatever it says, or refused.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "display_options.h"
#include "file_descriptor.h"
#include "scan_out.h"
#include "screen_inventory.h"

struct fb_fix_screeninfo;
struct fb_var_screeninfo;

namespace vitrine {

/// What the kernel's two structs mean, with the reason if such a device cannot be used.
[[nodiscard]] FramebufferInfo framebuffer_info(const std::string& path, const fb_fix_screeninfo& fixed,
                                               const fb_var_screeninfo& variable);

/// All framebuffer devices, those that cannot be used with the reason.
[[nodiscard]] ScreenInventory list_framebuffers();

class FramebufferDevice {
 public:
  /// Sets the device's mode, with the format asked for or else as it is; panels on a serial bus show nothing
  /// before that. Throws DisplayUnavailable when it is absent, not ours to open, or of an unusable kind.
  FramebufferDevice(const std::filesystem::path& path, std::optional<PixelFormat> format);
  ~FramebufferDevice();
  FramebufferDevice(const FramebufferDevice&) = delete;
  FramebufferDevice& operator=(const FramebufferDevice&) = delete;

  [[nodiscard]] const FramebufferInfo& info() const { return info_; }
  [[nodiscard]] ScreenMemory memory() const;
  /// The first byte of what is shown.
  [[nodiscard]] std::byte* pixels() const { return pixels_; }
  /// Waits until the screen has been drawn, where the device can tell.
  void await_vsync();
  /// Whether the device is still there.
  [[nodiscard]] bool alive() const;

 private:
  FileDescriptor file_;
  FramebufferInfo info_;
  std::byte* mapped_ = nullptr;
  std::size_t mapped_bytes_ = 0;
  std::byte* pixels_ = nullptr;
  bool tells_vsync_ = true;
};

}  // namespace vitrine
