// Text on a surface: DejaVu Sans, anti-aliased, built into the program. Positions are whole numbers of 1/64
// pixel, so a text takes the same pixels every time.
#pragma once

#include <string_view>

#include "surface.h"

namespace vitrine {

/// Draws one line of UTF-8 text whose line box has its top-left corner at (x, y). `size_px` is the height of
/// the em square, at least 1. What the font lacks and broken UTF-8 show as a replacement sign.
void draw_text(const Surface& surface, int x, int y, int size_px, Rgb8 colour, std::string_view text);

/// The advance of that line in pixels, rounded up.
[[nodiscard]] int text_width(int size_px, std::string_view text);

/// The height of a line box in pixels: from the highest ascender to the lowest descender.
[[nodiscard]] int text_height(int size_px);

}  // namespace vitrine
