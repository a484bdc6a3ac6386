#include "picture_view.h"

#include <span>

namespace vitrine {

void show_picture(const Surface& surface, const DevelopedPicture& picture, bool dimmed) {
  if (picture.rgb.empty()) {
    fill_rect(surface, {0, 0, surface.width, surface.height}, {});
    return;
  }
  const std::size_t row_bytes = static_cast<std::size_t>(picture.width) * 3;
  std::vector<std::uint8_t> row(static_cast<std::size_t>(surface.width) * 3);
  for (int y = 0; y < surface.height; ++y) {
    const std::uint8_t* from =
        picture.rgb.data() + static_cast<std::size_t>(y * picture.height / surface.height) * row_bytes;
    if (picture.width == surface.width && !dimmed) {
      write_rgb_row(surface, 0, y, std::span(from, row_bytes));
      continue;
    }
    for (int x = 0; x < surface.width; ++x) {
      const std::uint8_t* pixel = from + static_cast<std::ptrdiff_t>(x * picture.width / surface.width) * 3;
      for (int c = 0; c < 3; ++c) {
        row[static_cast<std::size_t>(x * 3 + c)] =
            dimmed ? static_cast<std::uint8_t>(pixel[c] / 2) : pixel[c];
      }
    }
    write_rgb_row(surface, 0, y, row);
  }
}

DevelopedPicture read_picture(const Surface& surface) {
  DevelopedPicture picture{surface.width, surface.height, {}};
  picture.rgb.reserve(static_cast<std::size_t>(surface.width) * static_cast<std::size_t>(surface.height) * 3);
  for (int y = 0; y < surface.height; ++y) {
    for (int x = 0; x < surface.width; ++x) {
      const Rgb8 pixel = read_pixel(surface, x, y);
      picture.rgb.insert(picture.rgb.end(), {pixel.r, pixel.g, pixel.b});
    }
  }
  return picture;
}

}  // namespace vitrine
