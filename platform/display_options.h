// Which screen, and how the upright picture lies on it. Everything here is optional: a box with one panel
// needs none of it. The backends read what concerns them: `card`, `connector` and `mode` are of KMS, `device`
// is of fbdev, the rest is of both. A window and frames in memory are upright always.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "display.h"

namespace vitrine {

/// How a picture of another size than the screen's is shown, always whole and with black borders.
enum class Scaling : std::uint8_t {
  kFitted,   ///< as large as the screen allows, each pixel the nearest of the picture
  kInteger,  ///< by the largest whole factor, so that all pixels are alike; fitted when the screen is smaller
};

struct DisplayOptions {
  std::string card{};  ///< of KMS: a driver's name ("vc4", "virtio_gpu") or a path; empty: the first that has
                       ///< a screen
  std::string connector{};  ///< as the kernel names it, "HDMI-A-1"; empty: the first with a screen
  std::string mode{};       ///< "1920x1080" or "1920x1080@60"; empty: what the screen prefers
  std::string device{};  ///< of fbdev: a path or a driver's id ("/dev/fb1", "fb_ili9341"); empty: the first
  int rotation = 0;      ///< by how many degrees the picture is turned clockwise: 0, 90, 180 or 270
  Scaling scaling = Scaling::kFitted;
  std::optional<PixelFormat> format{};  ///< of the screen's memory; none: the best that it offers
};

}  // namespace vitrine
