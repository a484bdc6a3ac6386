#include "button_strip.h"

#include <algorithm>
#include <array>
#include <utility>

#include "text.h"

namespace vitrine {
namespace {

constexpr int kGap = 10;
constexpr int kPadding = 12;
constexpr int kWidest = 150;
constexpr int kButtonHeight = 50;
constexpr int kRadius = 10;
constexpr int kCaptionSize = 15;
constexpr int kHintSize = 11;

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
  for (const ButtonSpec& button : buttons) {
    if (button.caption.empty()) continue;
    Face face{button.name, button.caption, {}};
    for (const ButtonSpec& other : buttons) {
      if (other.name != button.name || other.key.empty()) continue;
      face.hint += (face.hint.empty() ? "" : "  ") + key_hint(other.key);
    }
    const int text = std::max(text_width(kCaptionSize, face.caption), text_width(kHintSize, face.hint));
    narrowest_ = std::max(narrowest_, text + 2 * kPadding);
    faces_.push_back(std::move(face));
  }
}

int ButtonStrip::rows(int width) const {
  const int count = static_cast<int>(faces_.size());
  const int fit = std::max((width - kGap) / (narrowest_ + kGap), 1);
  return (count + fit - 1) / fit;
}

int ButtonStrip::height(int width) const {
  return faces_.empty() ? 0 : kGap + rows(width) * (kButtonHeight + kGap);
}

PixelRect ButtonStrip::rect(int width, std::size_t n) const {
  const int count = static_cast<int>(faces_.size());
  const int columns = (count + rows(width) - 1) / rows(width);  // rows of about one length
  const int row = static_cast<int>(n) / columns;
  const int column = static_cast<int>(n) % columns;
  const int in_row = std::min(columns, count - row * columns);
  const int button = std::min(std::max(kWidest, narrowest_), (width - kGap) / columns - kGap);
  const int left = (width - in_row * (button + kGap) + kGap) / 2;
  return {left + column * (button + kGap), kGap + row * (kButtonHeight + kGap), button, kButtonHeight};
}

std::optional<std::string> ButtonStrip::button_at(int width, int x, int y) const {
  for (std::size_t n = 0; n < faces_.size(); ++n) {
    if (rect(width, n).contains(x, y)) return faces_[n].name;
  }
  return std::nullopt;
}

void ButtonStrip::draw(const Surface& surface, const std::set<std::string>& pressed) const {
  fill_rect(surface, {0, 0, surface.width, surface.height}, kHousing);
  fill_rect(surface, {0, 0, surface.width, 1}, kHousingEdge);
  for (std::size_t n = 0; n < faces_.size(); ++n) {
    const Face& face = faces_[n];
    const bool down = pressed.contains(face.name);
    PixelRect cap = rect(surface.width, n);
    fill_rounded_rect(surface, {cap.x, cap.y + 2, cap.width, cap.height}, kRadius, kShadow);
    if (down) cap.y += 2;  // the cap goes down into its shadow
    fill_rounded_rect(surface, cap, kRadius, down ? kPressedRim : kRim);
    fill_rounded_rect(surface, {cap.x + 1, cap.y + 1, cap.width - 2, cap.height - 2}, kRadius - 1,
                      down ? kPressedCap : kCap);
    const int hint_height = face.hint.empty() ? 0 : text_height(kHintSize);
    const int top = cap.y + (cap.height - text_height(kCaptionSize) - hint_height) / 2;
    draw_centred(surface, cap, top, kCaptionSize, down ? kPressedText : kCaption, face.caption);
    draw_centred(surface, cap, top + text_height(kCaptionSize), kHintSize, down ? kPressedText : kHint,
                 face.hint);
  }
}

}  // namespace vitrine
