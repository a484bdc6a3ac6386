#include "frame/tone_map.h"

#include <cmath>

namespace vitrine {

const DisplayCurve& srgb_display_curve() {
  static const DisplayCurve curve = [] {
    DisplayCurve codes{};
    for (std::size_t i = 0; i < codes.size(); ++i) {
      const double x = static_cast<double>(i) / static_cast<double>(codes.size() - 1);
      const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
      codes[i] = static_cast<std::uint8_t>(std::lround(encoded * 255.0));
    }
    return codes;
  }();
  return curve;
}

}  // namespace vitrine
