// Texture look-up: 8-bit texels, decoded by a table, bilinear or nearest, wrapped as glTF's samplers say.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "numeric/vec.h"

namespace vitrine {

/// What the 256 values of a texel's channel mean: linear, or by the sRGB curve.
template <class N>
using TexelTable = std::array<typename N::Unit, 256>;

enum class Wrap : std::uint8_t { kRepeat, kMirror, kClamp };

template <class N>
struct Texture {
  using Unit = typename N::Unit;
  using TexCoord = typename N::TexCoord;

  const std::uint8_t* rgba = nullptr;  ///< width * height * 4 bytes, rows top to bottom, owned by the World
  int width = 0;
  int height = 0;
  int uv_set = 0;  ///< which of the World's texture coordinates
  Wrap wrap_s = Wrap::kRepeat;
  Wrap wrap_t = Wrap::kRepeat;
  bool nearest = false;

  /// The decoded colour at `uv`; v runs downwards as in glTF.
  [[nodiscard]] Vec3<Unit> sample(const Vec2<TexCoord>& uv, const TexelTable<N>& table) const {
    const Span s = span(uv.x, width, wrap_s);
    const Span t = span(uv.y, height, wrap_t);
    if (nearest) {
      return texel(s.fraction < Unit(0.5) ? s.first : s.second, t.fraction < Unit(0.5) ? t.first : t.second,
                   table);
    }
    const auto mix = [](const Vec3<Unit>& a, const Vec3<Unit>& b, Unit x) { return a + (b - a) * x; };
    return mix(mix(texel(s.first, t.first, table), texel(s.second, t.first, table), s.fraction),
               mix(texel(s.first, t.second, table), texel(s.second, t.second, table), s.fraction),
               t.fraction);
  }

 private:
  struct Span {  // two neighbouring texels and the way from one's centre to the other's
    int first;
    int second;
    Unit fraction;
  };
  static Span span(TexCoord x, int size, Wrap wrap) {
    const auto period = N::cell(x);
    Unit inside = period.fraction;
    if (wrap == Wrap::kMirror && (period.index & 1) != 0) inside = 1 - inside;
    if (wrap == Wrap::kClamp && period.index != 0) inside = period.index < 0 ? Unit(0) : Unit(1);
    const auto cell = N::texel(inside, size);
    const auto wrapped = [&](int i) {
      if (wrap == Wrap::kRepeat) return i < 0 ? i + size : (i >= size ? i - size : i);
      return i < 0 ? 0 : (i >= size ? size - 1 : i);
    };
    return {wrapped(cell.index), wrapped(cell.index + 1), cell.fraction};
  }
  [[nodiscard]] Vec3<Unit> texel(int x, int y, const TexelTable<N>& table) const {
    const std::uint8_t* p = rgba + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                        static_cast<std::size_t>(x));
    return {table[p[0]], table[p[1]], table[p[2]]};
  }
};

}  // namespace vitrine
