// A display without a screen: frames in memory, for tests, screenshots and machines where nobody watches.
#pragma once

#include "display.h"
#include "surface.h"

namespace vitrine {

class HeadlessDisplay final : public Display {
 public:
  HeadlessDisplay(int width, int height, PixelFormat format = PixelFormat::kXrgb8888)
      : frame_(width, height, format) {}

  [[nodiscard]] DisplayMode mode() const override {
    const Surface& surface = frame_.surface();
    return {surface.width, surface.height, surface.format};
  }
  Surface acquire() override { return frame_.surface(); }
  void present() override {}
  [[nodiscard]] Surface shown() const override { return frame_.surface(); }

 private:
  SurfaceMemory frame_;
};

}  // namespace vitrine
