// The seam to the screen. A backend offers a surface to draw into and shows it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace vitrine {

enum class PixelFormat : std::uint8_t {
  kXrgb8888,  ///< 32 bits a pixel, 0x00RRGGBB in the machine's byte order
  kRgb888,    ///< 3 bytes a pixel: R, G, B
  kRgb565,    ///< 16 bits a pixel, RRRRRGGGGGGBBBBB in the machine's byte order
};

struct DisplayMode {
  int width = 0;
  int height = 0;
  PixelFormat format = PixelFormat::kXrgb8888;
  double refresh_hz = 60.0;

  bool operator==(const DisplayMode&) const = default;
};

/// Pixels to draw into: `height` rows, `stride_bytes` apart. The stride is never assumed from the width.
struct Surface {
  std::byte* pixels = nullptr;
  int width = 0;
  int height = 0;
  std::size_t stride_bytes = 0;
  PixelFormat format = PixelFormat::kXrgb8888;
};

/// This machine, as it is now, lacks what a backend needs; `what()` is one line with a remedy.
class DisplayUnavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A screen. Used from one thread.
class Display {
 public:
  virtual ~Display() = default;
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  /// What the screen shows now. It may change in present() and in poll() of the screen's own buttons (a
  /// window is resized, a cable is plugged); acquire() gives a surface of this size and format.
  [[nodiscard]] virtual DisplayMode mode() const = 0;
  /// The surface of the next frame, valid until present(). Its old content is undefined.
  virtual Surface acquire() = 0;
  /// Shows what was drawn; waits for the flip where the backend can.
  virtual void present() = 0;
  /// Whether no screen is plugged in now. Until one is, present() shows nothing and returns at about 60 Hz.
  [[nodiscard]] virtual bool waiting_for_screen() const { return false; }
  /// The frame that present() showed last, to be read only and until the next acquire(); all black before the
  /// first.
  [[nodiscard]] virtual Surface shown() const = 0;

 protected:
  Display() = default;
};

}  // namespace vitrine
