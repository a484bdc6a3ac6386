// A material in a number system: factors and textures, and how they make the scattering and the emission of a
// point.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "materials/absorption.h"
#include "materials/bsdf.h"
#include "materials/texture.h"
#include "scene/baked_layers.h"
#include "scene/coverage.h"
#include "scene/normal_map.h"
#include "scene/surface_coordinates.h"

namespace vitrine {

template <class N>
struct BakedMaterial {
  using Unit = typename N::Unit;
  using Radiance = typename N::Radiance;

  Vec3<Unit> base_color;
  Unit metallic;
  Unit roughness;
  Vec3<Unit> dielectric_f0;  ///< before `specular` weighs it; may exceed 1
  Unit specular;
  Unit transmission;
  Transmission kind;
  Unit ior;
  bool solid = false;        ///< a boundary: what crosses it is inside, or out again
  Absorption<N> absorption;  ///< inside
  Vec3<Radiance> emission;
  bool emits = false;
  bool two_sided = false;
  std::optional<Texture<N>> base_color_texture;
  std::optional<Texture<N>> metallic_roughness_texture;
  std::optional<Texture<N>> specular_texture;  ///< its alpha
  std::optional<Texture<N>> specular_color_texture;
  std::optional<Texture<N>> transmission_texture;
  std::optional<Texture<N>> emission_texture;
  std::optional<NormalMap<N>> normal_map;
  Coverage<N> coverage;
  BakedSheen<N> sheen;
  BakedClearcoat<N> coat;

  /// `inside`: seen from behind, where a refracting solid is.
  [[nodiscard]] SurfaceScattering<N> scattering(const SurfaceCoordinates<N>& at, bool inside,
                                                const TexelTable<N>& srgb,
                                                const TexelTable<N>& linear) const {
    Vec3<Unit> base = base_color * at.color;
    Unit metal = metallic;
    Unit rough = roughness;
    Unit through = transmission;
    if (base_color_texture) base = base * sample(*base_color_texture, at, srgb);
    if (metallic_roughness_texture) {
      const Vec3<Unit> texel = sample(*metallic_roughness_texture, at, linear);
      rough *= texel.y;
      metal *= texel.z;
    }
    Vec3<Unit> f0 = dielectric_f0;
    Unit f90 = specular;
    if (specular_color_texture) f0 = f0 * sample(*specular_color_texture, at, srgb);
    if (specular_texture) f90 *= specular_texture->sample_alpha(at.uv(specular_texture->uv_set), linear);
    f0 = Vec3<Unit>(std::min(f0.x, Unit(1)), std::min(f0.y, Unit(1)), std::min(f0.z, Unit(1))) * f90;
    if (transmission_texture) through *= sample(*transmission_texture, at, linear).x;
    const Vec3<Unit> dielectric = base * (1 - metal);
    const Unit alpha = rough * rough;
    SurfaceScattering<N> s;
    s.diffuse = dielectric * (1 - through);
    s.f0 = f0 * (1 - metal) + base * metal;
    s.f90 = f90 * (1 - metal) + metal;
    s.transmit = dielectric * through;
    s.transmission = kind;
    s.eta = inside ? Unit(1) / ior : ior;
    s.smooth = alpha < smooth_below<N>();
    s.alpha = s.smooth ? Unit(1) : alpha;
    if (sheen.is_there()) s.sheen = sheen.at(at, srgb, linear);
    if (coat.is_there()) s.coat = coat.at(at, linear);
    return s;
  }

  /// Radiance that leaves the front (and the back, if two_sided).
  [[nodiscard]] Vec3<Radiance> emitted(const SurfaceCoordinates<N>& at, const TexelTable<N>& srgb) const {
    if (!emission_texture) return emission;
    return emission * sample(*emission_texture, at, srgb);
  }

 private:
  static Vec3<Unit> sample(const Texture<N>& texture, const SurfaceCoordinates<N>& at,
                           const TexelTable<N>& table) {
    return texture.sample(at.uv(texture.uv_set), table);
  }
};

}  // namespace vitrine
