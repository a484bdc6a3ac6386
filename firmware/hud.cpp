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

/// Legible on a panel of 320x240, in proportion on larger ones.
int text_size(const Surface& surface) {
  return std::max(12, std::min(surface.height / 28, surface.width / 36));
}

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
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

/// Draws lines on a plate that is `y` pixels down, or so far up from the bottom when negative.
void draw_plate(const Surface& surface, int y, std::span<const std::string> texts) {
  const int size = text_size(surface);
  const int margin = size / 2;
  const std::vector<std::string> lines = wrapped(texts, size, surface.width - 4 * margin);
  if (lines.empty()) return;
  int width = 0;
  for (const std::string& line : lines) width = std::max(width, text_width(size, line));
  const int height = static_cast<int>(lines.size()) * text_height(size) + margin;
  const int top = y >= 0 ? y : surface.height + y - height;
  fill_rect(surface, {margin, top, width + 2 * margin, height}, kPlate, kPlateCoverage);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    draw_text(surface, 2 * margin, top + margin / 2 + static_cast<int>(i) * text_height(size), size, kBright,
              lines[i]);
  }
}

}  // namespace

std::vector<std::string> hud_lines(const HudState& state) {
  if (!state.visible) return {};
  std::vector<std::string> lines{state.title, state.mode + (state.unbiased ? "" : " (biased)")};
  std::string progress = state.numbers + " · " + std::to_string(state.samples_per_pixel) + " spp";
  if (state.frames_per_second > 0.0) progress += format(" · %.1f fps", state.frames_per_second);
  lines.push_back(progress + " · " + clock_time(state.seconds));
  if (state.exposure_stops) lines.push_back(format("exposure %+.2f EV", *state.exposure_stops));
  if (state.loading) lines.emplace_back("loading …");
  if (state.paused) lines.emplace_back("paused");
  if (!state.notice.empty()) lines.push_back(state.notice);
  return lines;
}

void draw_hud(const Surface& surface, const HudState& state) {
  const int margin = text_size(surface) / 2;
  if (!state.error.empty()) {
    fill_rect(surface, {0, 0, surface.width, surface.height}, kCard);
    draw_plate(surface, -margin, std::array{state.title + " cannot be shown", state.error});
  } else if (state.visible && !state.caption.empty()) {
    draw_plate(surface, -margin, std::array{state.caption});
  }
  draw_plate(surface, margin, hud_lines(state));
}

}  // namespace vitrine
