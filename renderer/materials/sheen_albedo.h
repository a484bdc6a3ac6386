// How much a white sheen scatters in all, E(cosine, roughness): by it the layer below is dimmed, as
// KHR_materials_sheen recommends. A table that is made once, in the number system's own arithmetic, so that
// fixed point stays the same on every machine. Along the surface the sharpest fits of Charlie scatter more
// than they get; there the sheen is dimmed to what it got.
//
//   f = s f_sheen + (1 - max(color) min(1, E)) f_base,   s = min(1, 1 / E),   E = max(E(co), E(ci))
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "materials/sheen.h"

namespace vitrine {

template <class N>
class SheenAlbedo {
  using Unit = typename N::Unit;
  using Density = typename N::Density;

 public:
  /// The table, which is made when it is first asked for.
  static const SheenAlbedo& table() {
    static const SheenAlbedo once;
    return once;
  }

  /// cosine and roughness in [0, 1].
  [[nodiscard]] Unit operator()(Unit cosine, Unit roughness) const {
    const Unit least = Charlie<N>::least_roughness();
    // The first and the last row are of the least and of the greatest roughness.
    const Unit along = (roughness - least) * Unit((kSize - 1.0) / (0.9 * kSize)) + Unit(0.5 / kSize);
    const auto x = N::texel(sqrt(cosine), kSize);
    const auto y = N::texel(std::max(along, Unit(0)), kSize);
    const Unit low = row(y.index).at(x);
    const Unit high = row(y.index + 1).at(x);
    return low + (high - low) * y.fraction;
  }

 private:
  static constexpr int kSize = 32;
  static constexpr int kAzimuths = 16;

  SheenAlbedo() {
    Unit roughness = Charlie<N>::least_roughness();
    for (Row& row : rows_) {
      row = albedos(Charlie<N>(roughness));
      roughness += Unit(0.9 / (kSize - 1));
    }
  }

  static constexpr std::size_t clamped(int i) {
    return static_cast<std::size_t>(std::clamp(i, 0, kSize - 1));
  }

  struct Row {  // by cosine: finer near 0, where the rim is
    std::array<Unit, kSize> albedo;
    template <class Cell>
    [[nodiscard]] Unit at(const Cell& x) const {
      const Unit low = albedo[clamped(x.index)];
      return low + (albedo[clamped(x.index + 1)] - low) * x.fraction;
    }
  };
  [[nodiscard]] const Row& row(int i) const { return rows_[clamped(i)]; }

  // The middle of the i-th of 2^(31 - half_bits) parts of [0, 1].
  static constexpr Unit middle(int i, int half_bits) {
    return N::unit_from_bits(static_cast<std::uint32_t>(2 * i + 1) << half_bits);
  }

  // By the midpoint rule, over the cosine's root and half of the azimuths.
  static Row albedos(const Charlie<N>& charlie) {
    std::array<Vec3<Unit>, kSize> meridian;
    std::array<Density, kSize> lambda;
    for (int i = 0; i < kSize; ++i) {
      const Unit root = middle(i, 26);
      const Unit z = root * root;
      meridian[clamped(i)] = {sqrt(1 - z * z), Unit(0), z};
      lambda[clamped(i)] = charlie.lambda(z);
    }
    Row row;
    for (std::size_t o = 0; o < kSize; ++o) {
      const Vec3<Unit>& wo = meridian[o];
      Density sum(0);
      for (std::size_t i = 0; i < kSize; ++i) {
        Density facets(0);
        for (int j = 0; j < kAzimuths; ++j) {
          const auto [sine, cosine] = sincos_turns(middle(j, 27) * Unit(0.5));
          const Vec3<Unit> wi(meridian[i].x * cosine, meridian[i].x * sine, meridian[i].z);
          facets += charlie.d(normalize(wo + wi));
        }
        const Unit root = middle(static_cast<int>(i), 26);
        sum += facets * Density(root) / (Density(1) + lambda[o] + lambda[i]);
      }
      // the area that stands for each direction: 2 root / kSize by 2 pi / kAzimuths
      row.albedo[o] =
          Unit(sum * Density(3.141592653589793 * 4.0 / (kSize * kAzimuths)) / (Density(4) * Density(wo.z)));
    }
    return row;
  }

  std::array<Row, kSize> rows_;
};

}  // namespace vitrine
