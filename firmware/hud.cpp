#include "hud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <utility>

#include "text.h"

namespace vitrine {
namespace {

constexpr Rgb8 kBright{255, 255, 255};
constexpr Rgb8 kPlate{0, 0, 0};
constexpr int kPlateCoverage = 150;
constexpr Rgb8 kCard{60, 16, 16};
constexpr int kCardCoverage = 225;

constexpr int kSmallestText = 12;

/// Legible on a panel of 320x240, in proportion on larger ones.
int text_size(const Surface& surface) {
  return std::max(kSmallestText, std::min(surface.height / 28, surface.width / 36));
}

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

/// "4.1 Mrays/s"
std::string ray_rate(double rays_per_second) {
  return rays_per_second >= 999'500.0 ? format("%.1f Mrays/s", rays_per_second * 1e-6)
                                      : format("%.0f krays/s", rays_per_second * 1e-3);
}

std::string clock_time(double seconds) {
  const auto whole = static_cast<int>(seconds);
  char text[32];
  std::snprintf(text, sizeof text, "%d:%02d", whole / 60, whole % 60);
  return text;
}

/// Cut at spaces so that no line is wider than `width`; a word that is wider alone is cut where it must be.
std::vector<std::string> wrapped(const std::string& text, int size_px, int width) {
  std::vector<std::string> lines;
  std::string line;
  const auto fits = [&](const std::string& candidate) { return text_width(size_px, candidate) <= width; };
  std::size_t begin = 0;
  while (begin < text.size()) {
    std::size_t end = std::min(text.find(' ', begin), text.size());
    std::string word = text.substr(begin, end - begin);
    if (!line.empty() && !fits(line + ' ' + word)) lines.push_back(std::exchange(line, ""));
    while (!fits(word) && word.size() > 1) {
      std::size_t length = word.size() - 1;
      while (length > 1 && !fits(word.substr(0, length))) --length;
      lines.push_back(word.substr(0, length));
      word.erase(0, length);
    }
    line += (line.empty() ? "" : " ") + word;
    begin = end + 1;
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

std::vector<std::string> wrapped(std::span<const std::string> texts, int size_px, int width) {
  std::vector<std::string> lines;
  for (const std::string& text : texts) {
    for (std::string& line : wrapped(text, size_px, width)) lines.push_back(std::move(line));
  }
  return lines;
}

/// Where a plate lies: its columns [left, right), and `y` pixels down, or so far up from the bottom when
/// negative.
struct PlatePlace {
  int left;
  int right;
  int y;
};

/// Draws lines on a plate no larger than they are; returns the row beneath it.
int draw_plate(const Surface& surface, const PlatePlace& place, std::span<const std::string> texts,
               Rgb8 color = kPlate, int coverage = kPlateCoverage) {
  const int size = text_size(surface);
  const int margin = size / 2;
  const std::vector<std::string> lines = wrapped(texts, size, place.right - place.left - 4 * margin);
  if (lines.empty()) return place.y;
  int width = 0;
  for (const std::string& line : lines) width = std::max(width, text_width(size, line));
  const int height = static_cast<int>(lines.size()) * text_height(size) + margin;
  const int top = place.y >= 0 ? place.y : surface.height + place.y - height;
  fill_rect(surface, {place.left + margin, top, width + 2 * margin, height}, color, coverage);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    draw_text(surface, place.left + 2 * margin, top + margin / 2 + static_cast<int>(i) * text_height(size),
              size, kBright, lines[i]);
  }
  return top + height;
}

}  // namespace

std::string percent(double ratio) {
  const double value = 100.0 * ratio;
  return format(value >= 9.95 ? "%.0f %%" : value >= 0.995 ? "%.1f %%" : "%.2f %%", value);
}

std::vector<std::string> side_lines(const HudSide& side) {
  std::vector<std::string> lines{side.mode};
  if (!side.changes.empty()) lines.push_back(side.changes);
  if (!side.bias.empty()) lines.push_back("biased: " + side.bias);
  lines.push_back(std::to_string(side.samples_per_pixel) + " spp" +
                  (side.error ? " · error " + percent(*side.error) : ""));
  return lines;
}

std::vector<std::string> hud_lines(const HudState& state) {
  if (!state.visible) return {};
  std::vector<std::string> lines{state.title};
  if (state.sides.size() == 1) {
    for (std::string& line : side_lines(state.sides.front())) lines.push_back(std::move(line));
  }
  std::string session = state.numbers;
  if (state.sides.size() > 1) session += " · " + state.fairness;
  if (state.frames_per_second > 0.0) session += format(" · %.1f fps", state.frames_per_second);
  if (state.rays_per_second > 0.0) session += " · " + ray_rate(state.rays_per_second);
  lines.push_back(session + " · " + clock_time(state.seconds));
  if (!state.view.empty()) lines.push_back(state.view + ": " + state.view_legend);
  if (state.exposure_stops) lines.push_back(format("exposure %+.2f EV", *state.exposure_stops));
  if (state.loading) lines.emplace_back("loading …");
  if (state.paused) lines.emplace_back("paused");
  if (state.done && !state.paused) lines.emplace_back("done: resting");
  if (!state.governor.empty()) lines.push_back(state.governor);
  if (!state.notice.empty()) lines.push_back(state.notice);
  return lines;
}

std::vector<std::string> hud_text(const HudState& state) {
  std::vector<std::string> text = hud_lines(state);
  if (state.visible) {
    for (const HudSide& side : state.sides) {
      for (std::string& line : side_lines(side)) text.push_back(std::move(line));
    }
    text.push_back(state.caption);
  }
  text.push_back(std::to_string(state.split));
  text.push_back(std::to_string(state.offset.x) + "," + std::to_string(state.offset.y));
  text.push_back(state.error);
  return text;
}

int split_column(double split, int width) {
  return std::clamp(static_cast<int>(std::lround(split * width)), 0, width);
}

void draw_side_labels(const Surface& surface, std::span<const HudSide> sides, double split, int top,
                      int shift) {
  const int column = split_column(split, surface.width);
  // A side may be too narrow for a label of its own; then there is none.
  const int narrowest = 8 * text_size(surface);
  const std::array places{PlatePlace{shift, column, top}, PlatePlace{column + shift, surface.width, top}};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (places[i].right - places[i].left >= narrowest) draw_plate(surface, places[i], side_lines(sides[i]));
  }
}

void draw_hud(const Surface& surface, const HudState& state) {
  const int margin = text_size(surface) / 2;
  static_assert(kMaxPixelShift < kSmallestText / 2, "the lower labels walk within their margin");
  const PlatePlace bottom{state.offset.x, surface.width, -margin + state.offset.y};
  if (!state.error.empty()) {
    if (!state.over_picture) fill_rect(surface, {0, 0, surface.width, surface.height}, kCard);
    draw_plate(surface, bottom, std::array{state.error_title, state.error}, kCard, kCardCoverage);
  } else if (state.visible && !state.caption.empty()) {
    draw_plate(surface, bottom, std::array{state.caption});
  }
  const int below =
      draw_plate(surface, {state.offset.x, surface.width, margin + state.offset.y}, hud_lines(state));
  if (state.visible && state.sides.size() > 1)
    draw_side_labels(surface, state.sides, state.split, below + margin, state.offset.x);
}

}  // namespace vitrine
