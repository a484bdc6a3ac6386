// A material in a number system: factors and textures, and how they make the scattering and the emission of a
// point.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "materials/bsdf.h"
#include "materials/texture.h"

namespace vitrine {

/// Roughness below which a lobe is a delta distribution: alpha = 0.001.
template <class N>
constexpr typename N::Unit smooth_below() {
  return typename N::Unit(0.001);
}

/// A texture coordinate of every vertex.
template <class N>
using UvSet = std::vector<Vec2<typename N::TexCoord>>;

/// Where on a triangle a point is, and what varies from there to there.
template <class N>
struct SurfaceCoordinates {
  using Unit = typename N::Unit;

  std::span<const UvSet<N>> uv_sets;
  glm::uvec3 corners;  ///< vertices of the triangle
  Vec3<Unit> weights;  ///< their barycentric weights
  Vec3<Unit> color;    ///< of the vertices, multiplies the base colour

  [[nodiscard]] Vec2<typename N::TexCoord> uv(int set) const {
    const UvSet<N>& uv = uv_sets[static_cast<std::size_t>(set)];
    return uv[corners.x] * weights.x + uv[corners.y] * weights.y + uv[corners.z] * weights.z;
  }
};

template <class N>
struct BakedMaterial {
  using Unit = typename N::Unit;
  using Radiance = typename N::Radiance;

  Vec3<Unit> base_color;
  Unit metallic;
  Unit roughness;
  Vec3<Unit> dielectric_f0;
  Unit dielectric_f90;
  Unit transmission;
  Transmission kind;
  Unit ior;
  Vec3<Radiance> emission;
  bool emits = false;
  bool two_sided = false;
  std::optional<Texture<N>> base_color_texture;
  std::optional<Texture<N>> metallic_roughness_texture;
  std::optional<Texture<N>> transmission_texture;
  std::optional<Texture<N>> emission_texture;

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
    if (transmission_texture) through *= sample(*transmission_texture, at, linear).x;
    const Vec3<Unit> dielectric = base * (1 - metal);
    const Unit alpha = rough * rough;
    SurfaceScattering<N> s;
    s.diffuse = dielectric * (1 - through);
    s.f0 = dielectric_f0 * (1 - metal) + base * metal;
    s.f90 = dielectric_f90 * (1 - metal) + metal;
    s.transmit = dielectric * through;
    s.transmission = kind;
    s.eta = inside ? Unit(1) / ior : ior;
    s.smooth = alpha < smooth_below<N>();
    s.alpha = s.smooth ? Unit(1) : alpha;
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
