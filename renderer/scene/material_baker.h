// Materials on their way into a number system. Texture coordinates are transformed once a vertex, so each
// pair of a set and a transform that some texture uses becomes a set of its own.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "numeric/host_conversion.h"
#include "scene/baked_material.h"
#include "scene/scene.h"

namespace vitrine {

template <class N>
class MaterialBaker {
  using Unit = typename N::Unit;

 public:
  /// `images` must live as long as the materials do. Lengths are multiplied by `scale`; radiance 1 is
  /// 2^exponent nits.
  MaterialBaker(const std::vector<Image>& images, double scale, int exponent)
      : images_(images), scale_(scale), exponent_(exponent) {}

  /// The sets of texture coordinates that the materials so far use.
  [[nodiscard]] std::span<const TextureUse> uv_sets() const { return uv_sets_; }

  BakedMaterial<N> bake(const Material& m) {
    // An index of 0 stands for an infinite one: it reflects everything (KHR_materials_ior).
    const double ior = static_cast<double>(m.ior);
    const double r = ior == 0.0 ? 1.0 : (ior - 1.0) / (ior + 1.0);
    const bool bends = m.refracts && std::abs(ior - 1.0) > kStraightIor;
    return {.base_color = units(m.base_color),
            .metallic = unit(m.metallic),
            .roughness = unit(m.roughness),
            .dielectric_f0 = from_host<Unit>(glm::min(glm::dvec3(m.specular_color) * (r * r), kMaxF0)),
            .specular = unit(m.specular),
            .transmission = unit(m.transmission),
            .kind = bends ? Transmission::kRefract : Transmission::kThin,
            .ior = from_host<Unit>(std::clamp(ior, 1.0, kMaxIor)),
            .solid = is_solid(m),
            .absorption = absorption(m),
            .emission = from_host<typename N::Radiance>(glm::dvec3(m.emission) * std::ldexp(1.0, -exponent_)),
            .emits = std::max({m.emission.x, m.emission.y, m.emission.z}) > 0.0F,
            .two_sided = m.double_sided,
            .base_color_texture = texture(m.base_color_texture),
            .metallic_roughness_texture = texture(m.metallic_roughness_texture),
            .specular_texture = texture(m.specular_texture),
            .specular_color_texture = texture(m.specular_color_texture),
            .transmission_texture = texture(m.transmission_texture),
            .emission_texture = texture(m.emission_texture),
            .normal_map = normal_map(m),
            .coverage = coverage(m),
            .sheen = {units(m.sheen_color), unit(m.sheen_roughness), texture(m.sheen_color_texture),
                      texture(m.sheen_roughness_texture)},
            .coat = {unit(m.clearcoat), unit(m.clearcoat_roughness), texture(m.clearcoat_texture),
                     texture(m.clearcoat_roughness_texture)}};
  }

 private:
  static constexpr double kMaxIor = 2.9;         // what the Fresnel terms of the fixed system can hold
  static constexpr double kStraightIor = 1e-3;   // closer to 1, a solid bends no light
  static constexpr double kMaxF0 = 3.9;          // what a Unit holds: a texture's 0.25 of it still reaches 1
  static constexpr double kMaxAbsorption = 1e9;  // nothing is left of light at the smallest distance

  static Unit unit(float x) { return from_host<Unit>(std::clamp(static_cast<double>(x), 0.0, 1.0)); }
  static Vec3<Unit> units(const glm::vec3& v) { return {unit(v.x), unit(v.y), unit(v.z)}; }

  int uv_set(const TextureUse& use) {
    const auto found = std::ranges::find_if(uv_sets_, [&](const TextureUse& other) {
      return other.texcoord == use.texcoord && other.transform == use.transform;
    });
    if (found != uv_sets_.end()) return static_cast<int>(found - uv_sets_.begin());
    uv_sets_.push_back(use);
    return static_cast<int>(uv_sets_.size()) - 1;
  }

  std::optional<Texture<N>> texture(const TextureUse& use) {
    if (!use) return std::nullopt;
    const Image& image = images_[static_cast<std::size_t>(use.image)];
    const auto wrap = [](TextureWrap w) {
      return w == TextureWrap::kRepeat ? Wrap::kRepeat
                                       : (w == TextureWrap::kMirroredRepeat ? Wrap::kMirror : Wrap::kClamp);
    };
    return Texture<N>{.rgba = image.rgba.data(),
                      .width = image.width,
                      .height = image.height,
                      .uv_set = uv_set(use),
                      .wrap_s = wrap(use.wrap_s),
                      .wrap_t = wrap(use.wrap_t),
                      .nearest = use.nearest};
  }

  static bool is_solid(const Material& m) { return m.refracts && m.transmission > 0.0F; }
  [[nodiscard]] Absorption<N> absorption(const Material& m) const {
    Absorption<N> result;
    if (!is_solid(m) || !m.attenuation_distance) return result;
    const double distance = static_cast<double>(*m.attenuation_distance) * scale_;
    for (int c = 0; c < 3; ++c) {
      const double a = -std::log(static_cast<double>(m.attenuation_color[c])) / distance;
      result.coefficient[c] = from_host<typename N::Density>(std::clamp(a, 0.0, kMaxAbsorption));
    }
    return result;
  }

  std::optional<NormalMap<N>> normal_map(const Material& m) {
    const auto map = texture(m.normal_texture);
    if (!map) return std::nullopt;
    // Only the ratio of the factors counts, so none need be beyond 1.
    const auto xy = static_cast<double>(m.normal_scale);
    return NormalMap<N>{*map, from_host<Unit>(glm::dvec3(xy, xy, 1.0) / std::max(1.0, std::abs(xy)))};
  }

  Coverage<N> coverage(const Material& m) {
    Coverage<N> result;
    if (m.alpha_mode == AlphaMode::kOpaque) return result;
    const auto cutoff = from_host<Unit>(std::clamp(static_cast<double>(m.alpha_cutoff), 0.0, 2.0));
    result.alpha = unit(m.alpha);
    if (m.alpha_mode == AlphaMode::kMask) result.cutoff = cutoff;
    result.texture = texture(m.alpha_texture);
    double least = std::clamp(static_cast<double>(m.alpha), 0.0, 1.0);
    if (m.alpha_texture) least *= lowest_alpha(images_[static_cast<std::size_t>(m.alpha_texture.image)]);
    result.complete = least >= (m.alpha_mode == AlphaMode::kMask ? static_cast<double>(m.alpha_cutoff) : 1.0);
    return result;
  }
  static double lowest_alpha(const Image& image) {
    std::uint8_t lowest = 255;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) lowest = std::min(lowest, image.rgba[i]);
    return lowest / 255.0;
  }

  const std::vector<Image>& images_;
  double scale_;
  int exponent_;
  std::vector<TextureUse> uv_sets_;
};

}  // namespace vitrine
