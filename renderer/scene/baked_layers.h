// The layers over a material, sheen and clear coat, as factors and textures; and what they come to at a
// point.
#pragma once

#include <optional>

#include "materials/bsdf.h"
#include "materials/texture.h"
#include "scene/surface_coordinates.h"

namespace vitrine {

template <class N>
struct BakedSheen {
  using Unit = typename N::Unit;

  Vec3<Unit> color = Vec3<Unit>(0);  ///< 0: there is none
  Unit roughness = Unit(0);
  std::optional<Texture<N>> color_texture;
  std::optional<Texture<N>> roughness_texture;  ///< its alpha

  [[nodiscard]] bool is_there() const { return max_component(color) > 0; }
  [[nodiscard]] SheenLayer<N> at(const SurfaceCoordinates<N>& at, const TexelTable<N>& srgb,
                                 const TexelTable<N>& linear) const {
    SheenLayer<N> layer{color, roughness, &SheenAlbedo<N>::table()};
    if (color_texture) layer.color = color * color_texture->sample(at.uv(color_texture->uv_set), srgb);
    if (roughness_texture) {
      layer.roughness *= roughness_texture->sample_alpha(at.uv(roughness_texture->uv_set), linear);
    }
    return layer;
  }
};

template <class N>
struct BakedClearcoat {
  using Unit = typename N::Unit;

  Unit weight = Unit(0);  ///< 0: there is none
  Unit roughness = Unit(0);
  std::optional<Texture<N>> weight_texture;     ///< its red
  std::optional<Texture<N>> roughness_texture;  ///< its green

  [[nodiscard]] bool is_there() const { return weight > 0; }
  [[nodiscard]] Clearcoat<N> at(const SurfaceCoordinates<N>& at, const TexelTable<N>& linear) const {
    Unit w = weight;
    Unit r = roughness;
    if (weight_texture) w *= weight_texture->sample(at.uv(weight_texture->uv_set), linear).x;
    if (roughness_texture) r *= roughness_texture->sample(at.uv(roughness_texture->uv_set), linear).y;
    const Unit alpha = r * r;
    const bool smooth = alpha < smooth_below<N>();
    return {w, smooth ? Unit(1) : alpha, smooth};
  }
};

}  // namespace vitrine
