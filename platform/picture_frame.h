// The frame that is drawn upright in cached memory and copied out to a screen: of the size that was asked
// for, or as large as the screen, turned as that hangs. Until there is a screen it has a usual size.
#pragma once

#include "scan_out.h"
#include "surface.h"

namespace vitrine {

/// `asked`, or where it lacks width or height, the size of a picture without a screen.
[[nodiscard]] inline Extent or_usual(Extent asked) {
  return asked.width > 0 && asked.height > 0 ? asked : Extent{800, 480};
}

class PictureFrame {
 public:
  /// Without width or height: as large as the screen.
  explicit PictureFrame(Extent asked)
      : follows_screen_(asked.width <= 0 || asked.height <= 0), memory_(black(or_usual(asked))) {}

  /// A screen of this size is there; what was drawn stays unless the size changes.
  void fit(Extent screen, int rotation) {
    const Extent wanted = follows_screen_ ? turned(screen, rotation) : size();
    if (wanted != size()) memory_ = black(wanted);
  }

  [[nodiscard]] const Surface& surface() const { return memory_.surface(); }
  [[nodiscard]] Extent size() const { return {surface().width, surface().height}; }

 private:
  [[nodiscard]] static SurfaceMemory black(Extent size) {
    return {size.width, size.height, PixelFormat::kXrgb8888};
  }

  bool follows_screen_;
  SurfaceMemory memory_;
};

}  // namespace vitrine
