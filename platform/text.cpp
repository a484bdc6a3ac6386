#include "text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <mutex>
#include <vector>

#include <stb_truetype.h>

// NOLINTNEXTLINE(readability-identifier-naming): the name in font_data.S.in
extern "C" const unsigned char vitrine_font[];

namespace vitrine {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

/// Takes the first character off `text`, which must not be empty.
char32_t next_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const int leading_ones = std::countl_one(byte(0));
  const auto length = static_cast<std::size_t>(std::max(leading_ones, 1));
  bool valid = leading_ones != 1 && length <= 4 && length <= text.size();
  char32_t character = byte(0) & (0xFFU >> leading_ones);
  for (std::size_t i = 1; valid && i < length; ++i) {
    valid = (byte(i) & 0xC0U) == 0x80U;
    character = character << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};  // a shorter form would do below
  valid = valid && character >= kLeast[length] && character <= 0x10FFFF &&
          (character < 0xD800 || character > 0xDFFF);
  text.remove_prefix(valid ? length : 1);
  return valid ? character : kReplacement;
}

/// The coverage of a glyph's pixels, and where they lie from the pen on the baseline.
struct Glyph {
  std::vector<unsigned char> coverage;
  int x = 0, y = 0, width = 0, height = 0;
};

/// The built-in font at every size that was asked for. Safe to use from several threads.
class Font {
 public:
  Font() {
    stbtt_InitFont(&info_, vitrine_font, 0);
    stbtt_GetFontVMetrics(&info_, &ascent_, &descent_, nullptr);
    // stb_truetype gives a scale only; it is 1 over the em square in font units for an em of one pixel.
    units_per_em_ = static_cast<int>(1.0F / stbtt_ScaleForMappingEmToPixels(&info_, 1.0F) + 0.5F);
    replacement_ = stbtt_FindGlyphIndex(&info_, static_cast<int>(kReplacement));
  }

  [[nodiscard]] int ascent(int size_px) const { return pixels_up(ascent_, size_px); }
  [[nodiscard]] int height(int size_px) const { return ascent(size_px) + pixels_up(-descent_, size_px); }

  /// Calls place(glyph index, pen in 1/64 pixel) for each character and returns where the pen ends.
  template <class Place>
  int lay_out(int size_px, std::string_view text, Place&& place) const {
    int pen = 0;
    int previous = 0;
    while (!text.empty()) {
      int glyph = stbtt_FindGlyphIndex(&info_, static_cast<int>(next_character(text)));
      if (glyph == 0) glyph = replacement_;
      if (previous != 0) pen += sixty_fourths(stbtt_GetGlyphKernAdvance(&info_, previous, glyph), size_px);
      place(glyph, pen);
      int advance = 0;
      stbtt_GetGlyphHMetrics(&info_, glyph, &advance, nullptr);
      pen += sixty_fourths(advance, size_px);
      previous = glyph;
    }
    return pen;
  }

  /// The glyph moved right by `quarter` quarters of a pixel.
  const Glyph& glyph(int size_px, int index, int quarter) {
    const std::lock_guard lock(mutex_);
    const auto [entry, is_new] = glyphs_.try_emplace({size_px, index, quarter});
    if (is_new) entry->second = rasterised(size_px, index, quarter);
    return entry->second;  // the map's nodes never move
  }

 private:
  [[nodiscard]] Glyph rasterised(int size_px, int index, int quarter) const {
    const float scale = stbtt_ScaleForMappingEmToPixels(&info_, static_cast<float>(size_px));
    const float shift = 0.25F * static_cast<float>(quarter);
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&info_, index, scale, scale, shift, 0.0F, &x0, &y0, &x1, &y1);
    Glyph glyph{{}, x0, y0, x1 - x0, y1 - y0};
    glyph.coverage.resize(static_cast<std::size_t>(glyph.width) * static_cast<std::size_t>(glyph.height));
    if (!glyph.coverage.empty()) {
      stbtt_MakeGlyphBitmapSubpixel(&info_, glyph.coverage.data(), glyph.width, glyph.height, glyph.width,
                                    scale, scale, shift, 0.0F, index);
    }
    return glyph;
  }

  [[nodiscard]] int sixty_fourths(int font_units, int size_px) const {
    return static_cast<int>(std::int64_t{64} * font_units * size_px / units_per_em_);
  }
  [[nodiscard]] int pixels_up(int font_units, int size_px) const {
    return (font_units * size_px + units_per_em_ - 1) / units_per_em_;
  }

  stbtt_fontinfo info_{};
  int ascent_ = 0;
  int descent_ = 0;
  int units_per_em_ = 1;
  int replacement_ = 0;
  std::mutex mutex_;
  std::map<std::array<int, 3>, Glyph> glyphs_;  // by size, index and quarter
};

Font& font() {
  static Font instance;
  return instance;
}

}  // namespace

void draw_text(const Surface& surface, int x, int y, int size_px, Rgb8 colour, std::string_view text) {
  const int baseline = y + font().ascent(size_px);
  font().lay_out(size_px, text, [&](int index, int pen) {
    const int quarters = (pen + 8) >> 4;  // floor, also where kerning goes left of the start
    const Glyph& glyph = font().glyph(size_px, index, quarters & 3);
    const int left = x + (quarters >> 2) + glyph.x;
    const unsigned char* coverage = glyph.coverage.data();
    for (int j = 0; j < glyph.height; ++j) {
      for (int i = 0; i < glyph.width; ++i) {
        blend_pixel(surface, left + i, baseline + glyph.y + j, colour, *coverage++);
      }
    }
  });
}

int text_width(int size_px, std::string_view text) {
  return (font().lay_out(size_px, text, [](int, int) {}) + 63) / 64;
}

int text_height(int size_px) { return font().height(size_px); }

}  // namespace vitrine
