#include "button_strip.h"

#include <algorithm>
#include <array>
#include <utility>

#include "text.h"

namespace vitrine {
namespace {

constexpr int kWidestGrowth = 60;
constexpr std::size_t kFewRows = 3;
constexpr int kRadius = 10;

/// Sizes in pixels.
struct Style {
  int height;
  int gap;
  int padding;
  int caption;
  int hint;  ///< 0: hints are not shown
};
/// From roomy to dense.
constexpr std::array kStyleSizes{
    Style{.height = 50, .gap = 10, .padding = 12, .caption = 15, .hint = 11},
    Style{.height = 36, .gap = 6, .padding = 8, .caption = 13, .hint = 10},
    Style{.height = 26, .gap = 4, .padding = 6, .caption = 11, .hint = 0},
};

constexpr Rgb8 kHousing{28, 29, 32};
constexpr Rgb8 kHousingEdge{12, 12, 14};
constexpr Rgb8 kShadow{16, 17, 19};
constexpr Rgb8 kRim{84, 87, 94};
constexpr Rgb8 kCap{56, 59, 65};
constexpr Rgb8 kPressedRim{255, 205, 120};
constexpr Rgb8 kPressedCap{232, 158, 44};
constexpr Rgb8 kCaption{240, 240, 242};
constexpr Rgb8 kHint{158, 162, 170};
constexpr Rgb8 kPressedText{30, 20, 4};

/// SDL's name of a key as it is printed on one.
std::string key_hint(const std::string& key) {
  static const std::array<std::pair<std::string_view, std::string_view>, 6> kSigns = {{
      {"Left", "\u2190"},
      {"Up", "\u2191"},
      {"Right", "\u2192"},
      {"Down", "\u2193"},
      {"Escape", "Esc"},
      {"Return", "Enter"},
  }};
  const auto sign = std::ranges::find(kSigns, key, [](const auto& pair) { return pair.first; });
  return std::string(sign == kSigns.end() ? std::string_view(key) : sign->second);
}

void draw_centred(const Surface& surface, const PixelRect& rect, int y, int size_px, Rgb8 colour,
                  std::string_view text) {
  draw_text(surface, rect.x + (rect.width - text_width(size_px, text)) / 2, y, size_px, colour, text);
}

}  // namespace

ButtonStrip::ButtonStrip(std::span<const ButtonSpec> buttons) {
  static_assert(kStyleSizes.size() == kStyles);
  for (const ButtonSpec& button : buttons) {
    if (button.caption.empty()) continue;
    Face face{button.name, button.caption, {}, {}};
    for (const ButtonSpec& other : buttons) {
      if (other.name != button.name || other.key.empty()) continue;
      face.hint += (face.hint.empty() ? "" : "  ") + key_hint(other.key);
    }
    for (std::size_t i = 0; i < kStyles; ++i) {
      const Style& style = kStyleSizes[i];
      const int hint = style.hint > 0 ? text_width(style.hint, face.hint) : 0;
      face.widths[i] = std::max(text_width(style.caption, face.caption), hint) + 2 * style.padding;
    }
    faces_.push_back(std::move(face));
  }
}

std::vector<ButtonStrip::Row> ButtonStrip::fill_rows(int width, std::size_t style) const {
  const int gap = kStyleSizes[style].gap;
  std::vector<Row> rows;
  for (std::size_t n = 0; n < faces_.size(); ++n) {
    const int more = faces_[n].widths[style] + gap;
    if (rows.empty() || rows.back().width + more > width) rows.push_back({n, n, gap});
    rows.back().last = n + 1;
    rows.back().width += more;
  }
  return rows;
}

std::vector<ButtonStrip::Row> ButtonStrip::balanced_rows(int width, std::size_t style) const {
  std::vector<Row> rows = fill_rows(width, style);
  for (int narrower = width - 1; narrower > 0; --narrower) {
    std::vector<Row> candidate = fill_rows(narrower, style);
    const bool overflows =
        std::ranges::any_of(candidate, [&](const Row& row) { return row.width > narrower; });
    if (overflows || candidate.size() > rows.size()) break;
    rows = std::move(candidate);
  }
  return rows;
}

std::size_t ButtonStrip::choose_style(int width) const {
  std::size_t style = 0;
  while (style + 1 < kStyles && fill_rows(width, style).size() > kFewRows) ++style;
  return style;
}

int ButtonStrip::height(int width) const {
  if (faces_.empty()) return 0;
  const std::size_t style = choose_style(width);
  const auto& [height, gap, padding, caption, hint] = kStyleSizes[style];
  return gap + static_cast<int>(fill_rows(width, style).size()) * (height + gap);
}

std::vector<PixelRect> ButtonStrip::layout(int width) const {
  const std::size_t style = choose_style(width);
  const int height = kStyleSizes[style].height;
  const int gap = kStyleSizes[style].gap;
  std::vector<PixelRect> rects;
  int y = gap;
  for (const Row& row : balanced_rows(width, style)) {
    // What is left of the width makes all buttons of the row wider; some get an odd pixel.
    const auto count = static_cast<int>(row.last - row.first);
    const int spare = std::clamp(width - row.width, 0, count * kWidestGrowth);
    int x = std::max((width - row.width - spare) / 2, 0) + gap;
    for (int i = 0; i < count; ++i) {
      const int natural = faces_[row.first + static_cast<std::size_t>(i)].widths[style];
      const int grown = natural + spare * (i + 1) / count - spare * i / count;
      rects.push_back({x, y, grown, height});
      x += grown + gap;
    }
    y += height + gap;
  }
  return rects;
}

PixelRect ButtonStrip::rect(int width, std::size_t n) const { return layout(width)[n]; }

std::optional<std::string> ButtonStrip::button_at(int width, int x, int y) const {
  const std::vector<PixelRect> rects = layout(width);
  for (std::size_t n = 0; n < faces_.size(); ++n) {
    if (rects[n].contains(x, y)) return faces_[n].name;
  }
  return std::nullopt;
}

void ButtonStrip::draw(const Surface& surface, const std::set<std::string>& pressed) const {
  fill_rect(surface, {0, 0, surface.width, surface.height}, kHousing);
  fill_rect(surface, {0, 0, surface.width, 1}, kHousingEdge);
  const std::vector<PixelRect> rects = layout(surface.width);
  const Style& sizes = kStyleSizes[choose_style(surface.width)];
  const int radius = std::min(kRadius, sizes.height / 4);
  for (std::size_t n = 0; n < faces_.size(); ++n) {
    const Face& face = faces_[n];
    const bool down = pressed.contains(face.name);
    PixelRect cap = rects[n];
    fill_rounded_rect(surface, {cap.x, cap.y + 2, cap.width, cap.height}, radius, kShadow);
    if (down) cap.y += 2;  // the cap goes down into its shadow
    fill_rounded_rect(surface, cap, radius, down ? kPressedRim : kRim);
    fill_rounded_rect(surface, {cap.x + 1, cap.y + 1, cap.width - 2, cap.height - 2}, radius - 1,
                      down ? kPressedCap : kCap);
    const bool hinted = sizes.hint > 0 && !face.hint.empty();
    const int hint_height = hinted ? text_height(sizes.hint) : 0;
    const int top = cap.y + (cap.height - text_height(sizes.caption) - hint_height) / 2;
    draw_centred(surface, cap, top, sizes.caption, down ? kPressedText : kCaption, face.caption);
    if (hinted) {
      draw_centred(surface, cap, top + text_height(sizes.caption), sizes.hint, down ? kPressedText : kHint,
                   face.hint);
    }
  }
}

}  // namespace vitrine
