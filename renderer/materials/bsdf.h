// A surface's scattering at one point, seen from one direction: a Lambert lobe, a specular reflection and a
// transmission, each smooth (a mirror, a pane) or rough (GGX). The glTF 2.0 metallic-roughness model with
// KHR_materials_specular, _ior, _transmission and _volume maps onto these three.
//
// One lobe is chosen in proportion to what it is expected to reflect, and a rough sample is weighed by the
// density of the whole mixture. Smooth lobes are delta distributions: sample() finds them, eval() and pdf do
// not see them.
#pragma once

#include <cstdint>
#include <optional>

#include "materials/fresnel.h"
#include "materials/ggx.h"
#include "materials/lambert.h"
#include "materials/lobe.h"
#include "materials/microfacet_reflection.h"
#include "materials/microfacet_transmission.h"
#include "numeric/color.h"

namespace vitrine {

enum class Transmission : std::uint8_t {
  kThin,    ///< a wall without thickness: light goes straight on
  kRefract  ///< the boundary of a solid
};

/// The parameters of a surface point, of textures and factors.
template <class N>
struct SurfaceScattering {
  using Unit = typename N::Unit;
  Vec3<Unit> diffuse;   ///< albedo of the Lambert lobe before the reflection takes its share
  Vec3<Unit> f0;        ///< specular reflectance at normal incidence
  Unit f90;             ///< and at grazing; 0 with f0 = 0: no specular lobe
  Vec3<Unit> transmit;  ///< tint of the transmission
  Transmission transmission = Transmission::kThin;
  Unit eta;             ///< kRefract: n_t / n_i across the surface as wo sees it
  Unit alpha;           ///< GGX width
  bool smooth = false;  ///< delta lobes rather than GGX
};

template <class N>
struct BsdfValue {
  Vec3<typename N::Weight> f_cos;  ///< f * |cos wi|, 1/sr
  typename N::Density pdf_w;       ///< of sample(), 1/sr
};

template <class N>
struct BsdfSample {
  Vec3<typename N::Unit> wi;
  Vec3<typename N::Weight> weight;  ///< f * |cos wi| / pdf
  typename N::Density pdf_w;        ///< meaningless for a delta sample
  bool delta;
};

template <class N>
class Bsdf {
  using Unit = typename N::Unit;
  using Density = typename N::Density;
  using Weight = typename N::Weight;

 public:
  /// wo: unit, local, wo.z > 0.
  Bsdf(const SurfaceScattering<N>& surface, const Vec3<Unit>& wo)
      : surface_(surface), ggx_(surface.alpha), wo_(wo) {
    const bool refracts =
        surface.transmission == Transmission::kRefract && max_component(surface.transmit) > 0;
    exact_fresnel_ = refracts;
    has_specular_ = refracts || surface.f90 > 0;
    Unit reflected = has_specular_ ? luminance<Unit>(fresnel(wo.z)) : Unit(0);
    // Beyond the critical angle of its mean plane, a rough boundary still has facets that transmit.
    constexpr Unit kMostReflected(0.875);
    if (refracts && !surface.smooth && reflected > kMostReflected) reflected = kMostReflected;
    const Unit diffused = (1 - reflected) * luminance<Unit>(surface.diffuse);
    const Unit transmitted = (1 - reflected) * luminance<Unit>(surface.transmit);
    const Unit total = reflected + diffused + transmitted;
    if (!(total > 0)) return;
    prob_reflect_ = reflected / total;
    prob_transmit_ = transmitted / total;
    prob_diffuse_ = 1 - prob_reflect_ - prob_transmit_;
    if (!(diffused > 0)) {  // no rest of a rounding
      prob_diffuse_ = Unit(0);
      prob_reflect_ = 1 - prob_transmit_;
    }
  }

  /// Whether anything scatters other than by delta lobes, and whether some of it goes through.
  [[nodiscard]] bool is_rough() const {
    return prob_diffuse_ > 0 || (!surface_.smooth && prob_reflect_ + prob_transmit_ > 0);
  }
  [[nodiscard]] bool is_rough_both_sides() const { return !surface_.smooth && prob_transmit_ > 0; }
  /// The share of samples that the delta lobes get.
  [[nodiscard]] Unit prob_delta() const { return surface_.smooth ? prob_reflect_ + prob_transmit_ : Unit(0); }

  /// The rough lobes for a local direction on either side.
  [[nodiscard]] BsdfValue<N> eval(const Vec3<Unit>& wi) const {
    BsdfValue<N> value{Vec3<Weight>(0), Density(0)};
    if (wi.z > 0) {
      if (prob_diffuse_ > 0) add(eval_lambert<N>(diffuse_left_over(wi), wi), prob_diffuse_, value);
      if (prob_reflect_ > 0 && !surface_.smooth) {
        add(eval_microfacet_reflection(ggx_, wo_, wi, [this](Unit c) { return fresnel(c); }), prob_reflect_,
            value);
      }
    } else if (wi.z < 0 && prob_transmit_ > 0 && !surface_.smooth) {
      if (surface_.transmission == Transmission::kRefract) {
        add(eval_microfacet_transmission(ggx_, surface_.transmit, surface_.eta, wo_, wi), prob_transmit_,
            value);
      } else {  // the reflection lobe, turned to the other side
        const auto tint = [this](Unit c) { return surface_.transmit * (Vec3<Unit>(1) - fresnel(c)); };
        add(eval_microfacet_reflection(ggx_, wo_, Vec3<Unit>(wi.x, wi.y, -wi.z), tint), prob_transmit_,
            value);
      }
    }
    return value;
  }

  /// A direction by importance, or nothing when the light is absorbed. `choice` picks the lobe. What a rough
  /// lobe sends to the wrong side is absorbed: the density of the other side's lobes does not count it.
  [[nodiscard]] std::optional<BsdfSample<N>> sample(Unit choice, Unit u, Unit v) const {
    if (choice < prob_reflect_) {
      if (surface_.smooth) return delta_reflection();
      return reflected(sample_microfacet_reflection(ggx_, wo_, u, v));
    }
    if (choice < prob_reflect_ + prob_transmit_) {
      if (surface_.smooth) return delta_transmission();
      if (surface_.transmission == Transmission::kRefract) {
        const auto wi = sample_microfacet_transmission(ggx_, surface_.eta, wo_, u, v);
        return wi ? transmitted(*wi) : std::nullopt;
      }
      const Vec3<Unit> wi = sample_microfacet_reflection(ggx_, wo_, u, v);
      return transmitted(Vec3<Unit>(wi.x, wi.y, -wi.z));
    }
    if (!(prob_diffuse_ > 0)) return std::nullopt;
    return reflected(sample_lambert<N>(u, v));
  }

  /// One of the delta lobes; `choice` in [0, prob_delta()).
  [[nodiscard]] std::optional<BsdfSample<N>> sample_delta(Unit choice) const {
    return choice < prob_reflect_ ? delta_reflection() : delta_transmission();
  }

 private:
  [[nodiscard]] Vec3<Unit> fresnel(Unit cosine) const {
    const Unit c = cosine < 0 ? Unit(0) : cosine;
    if (exact_fresnel_) return Vec3<Unit>(fresnel_dielectric(c, surface_.eta).reflectance);
    return fresnel_schlick(surface_.f0, surface_.f90, c);
  }
  // What the specular reflection leaves to the Lambert lobe: glTF's fresnel_mix.
  [[nodiscard]] Vec3<Unit> diffuse_left_over(const Vec3<Unit>& wi) const {
    if (!has_specular_) return surface_.diffuse;
    return surface_.diffuse * (Vec3<Unit>(1) - fresnel(dot(wo_, normalize(wo_ + wi))));
  }

  static void add(const LobeValue<N>& lobe, Unit prob, BsdfValue<N>& value) {
    value.f_cos += lobe.tint * lobe.scale;
    value.pdf_w += lobe.pdf_w * prob;
  }
  [[nodiscard]] std::optional<BsdfSample<N>> weighed(const Vec3<Unit>& wi) const {
    const BsdfValue<N> value = eval(wi);
    if (!(value.pdf_w > 0)) return std::nullopt;
    return BsdfSample<N>{wi, value.f_cos / value.pdf_w, value.pdf_w, false};
  }
  [[nodiscard]] std::optional<BsdfSample<N>> reflected(const Vec3<Unit>& wi) const {
    return wi.z > 0 ? weighed(wi) : std::nullopt;
  }
  [[nodiscard]] std::optional<BsdfSample<N>> transmitted(const Vec3<Unit>& wi) const {
    return wi.z < 0 ? weighed(wi) : std::nullopt;
  }
  [[nodiscard]] std::optional<BsdfSample<N>> delta_reflection() const {
    return BsdfSample<N>{Vec3<Unit>(-wo_.x, -wo_.y, wo_.z), delta_weight(fresnel(wo_.z), prob_reflect_),
                         Density(1), true};
  }
  [[nodiscard]] std::optional<BsdfSample<N>> delta_transmission() const {
    const Vec3<Unit> tint = surface_.transmit * (Vec3<Unit>(1) - fresnel(wo_.z));
    if (surface_.transmission == Transmission::kThin) {
      return BsdfSample<N>{-wo_, delta_weight(tint, prob_transmit_), Density(1), true};
    }
    const Unit cos_t = fresnel_dielectric(wo_.z, surface_.eta).cos_t;
    if (!(cos_t > 0)) return std::nullopt;
    const Vec3<Unit> normal(Unit(0), Unit(0), Unit(1));
    return BsdfSample<N>{refract(wo_, normal, wo_.z, cos_t, surface_.eta),
                         delta_weight(tint, prob_transmit_) / Weight(square(surface_.eta)), Density(1), true};
  }
  static Vec3<Weight> delta_weight(const Vec3<Unit>& tint, Unit prob) {
    return Vec3<Weight>(Weight(tint.x), Weight(tint.y), Weight(tint.z)) / Weight(prob);
  }

  SurfaceScattering<N> surface_;
  Ggx<N> ggx_;
  Vec3<Unit> wo_;
  Unit prob_reflect_ = Unit(0);
  Unit prob_transmit_ = Unit(0);
  Unit prob_diffuse_ = Unit(0);
  bool has_specular_ = false;
  bool exact_fresnel_ = false;
};

}  // namespace vitrine
