#include "picture_view.h"

#include <algorithm>
#include <span>

namespace vitrine {

void show_picture(const Surface& surface, const DevelopedPicture& picture, bool dimmed, int left, int right) {
  if (left >= right) return;
  if (picture.rgb.empty()) {
    fill_rect(surface, {left, 0, right - left, surface.height}, {});
    return;
  }
  const std::size_t row_bytes = static_cast<std::size_t>(picture.width) * 3;
  std::vector<std::uint8_t> row(static_cast<std::size_t>(right - left) * 3);
  for (int y = 0; y < surface.height; ++y) {
    const std::uint8_t* from =
        picture.rgb.data() + static_cast<std::size_t>(y * picture.height / surface.height) * row_bytes;
    if (picture.width == surface.width && !dimmed) {
      write_rgb_row(surface, left, y, std::span(from + static_cast<std::ptrdiff_t>(left) * 3, row.size()));
      continue;
    }
    for (int x = left; x < right; ++x) {
      const std::uint8_t* pixel = from + static_cast<std::ptrdiff_t>(x * picture.width / surface.width) * 3;
      for (int c = 0; c < 3; ++c) {
        row[static_cast<std::size_t>((x - left) * 3 + c)] =
            dimmed ? static_cast<std::uint8_t>(pixel[c] / 2) : pixel[c];
      }
    }
    write_rgb_row(surface, left, y, row);
  }
}

void show_sides(const Surface& surface, std::span<const std::unique_ptr<Side>> sides, int column) {
  const bool two = sides.size() > 1;
  const int end_of_first = two ? column : surface.width;
  show_picture(surface, sides.front()->shown, sides.front()->outdated(), 0, end_of_first);
  if (!two) return;
  show_picture(surface, sides.back()->shown, sides.back()->outdated(), column, surface.width);
  draw_split(surface, column);
}

void draw_split(const Surface& surface, int column) {
  fill_rect(surface, {column - 1, 0, 2, surface.height}, {255, 255, 255});
}

void dim_surface(const Surface& surface, double level) {
  if (level >= 1.0) return;
  constexpr int kWhole = 256;
  const int factor = std::max(static_cast<int>(level * kWhole), 0);
  std::vector<std::uint8_t> row;
  row.reserve(static_cast<std::size_t>(surface.width) * 3);
  for (int y = 0; y < surface.height; ++y) {
    row.clear();
    for (int x = 0; x < surface.width; ++x) {
      const Rgb8 pixel = read_pixel(surface, x, y);
      for (const std::uint8_t channel : {pixel.r, pixel.g, pixel.b})
        row.push_back(static_cast<std::uint8_t>(channel * factor / kWhole));
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
