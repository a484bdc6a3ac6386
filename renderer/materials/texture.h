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
    return blend(uv, [&](int x, int y) {
      const std::uint8_t* p = texel(x, y);
      return Vec3<Unit>(table[p[0]], table[p[1]], table[p[2]]);
    });
  }
  /// The alpha channel at `uv`; it is always linear.
  [[nodiscard]] Unit sample_alpha(const Vec2<TexCoord>& uv, const TexelTable<N>& linear) const {
    return blend(uv, [&](int x, int y) { return linear[texel(x, y)[3]]; });
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
  // Of the texels around `uv`, as the sampler filters them.
  template <class Decode>
  [[nodiscard]] auto blend(const Vec2<TexCoord>& uv, const Decode& decoded) const {
    const Span s = span(uv.x, width, wrap_s);
    const Span t = span(uv.y, height, wrap_t);
    if (nearest) {
      return decoded(s.fraction < Unit(0.5) ? s.first : s.second,
                     t.fraction < Unit(0.5) ? t.first : t.second);
    }
    const auto mix = [](const auto& a, const auto& b, Unit x) { return a + (b - a) * x; };
    return mix(mix(decoded(s.first, t.first), decoded(s.second, t.first), s.fraction),
               mix(decoded(s.first, t.second), decoded(s.second, t.second), s.fraction), t.fraction);
  }
  [[nodiscard]] const std::uint8_t* texel(int x, int y) const {
    return rgba +
           4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
};

}  // namespace vitrine
