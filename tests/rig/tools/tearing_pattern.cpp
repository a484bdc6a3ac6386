// Frames of one colour each, which is the frame's number: what shows two colours is torn. `tearing_pattern
// [DISPLAY]` draws until it is ended; every row is drawn anew, from the top, with a pause in the middle of
// the frame.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <thread>

#include "backends.h"

namespace {

void draw(const vitrine::Surface& surface, std::uint32_t number) {
  for (int y = 0; y < surface.height; ++y) {
    std::byte* const row = surface.pixels + static_cast<std::size_t>(y) * surface.stride_bytes;
    for (int x = 0; x < surface.width; ++x)
      std::memcpy(row + static_cast<std::size_t>(x) * sizeof number, &number, sizeof number);
    if (y == surface.height / 2) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace

int main(int count, char** words) {
  try {
    const vitrine::Panel panel = vitrine::open_display(count > 1 ? words[1] : "drm", {.title = "tearing"});
    for (std::uint32_t frame = 1;; ++frame) {
      const vitrine::Surface surface = panel.display->acquire();
      if (surface.format != vitrine::PixelFormat::kXrgb8888) {
        std::fprintf(stderr, "tearing_pattern: wants 32 bits a pixel\n");
        return 1;
      }
      draw(surface, frame * 0x010305U & 0xffffffU);
      panel.display->present();
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tearing_pattern: %s\n", error.what());
    return 1;
  }
}
