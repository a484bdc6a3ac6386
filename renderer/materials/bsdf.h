// A surface's scattering at one point, seen from one direction: a Lambert lobe, a specular reflection and a
// transmission, each smooth (a mirror, a pane) or rough (GGX); over them a sheen, over that a clear coat. The
// glTF 2.0 metallic-roughness model with KHR_materials_specular, _ior, _transmission, _volume, _sheen and
// _clearcoat maps onto these five.
//
// One lobe is chosen in proportion to what it is expected to reflect, and a rough sample is weighed by the
// density of the whole mixture. Smooth lobes are delta distributions: sample() finds them, eval() and pdf do
// not see them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "materials/clearcoat.h"
#include "materials/direction_sampling.h"
#include "materials/fresnel.h"
#include "materials/ggx.h"
#include "materials/lambert.h"
#include "materials/lobe.h"
#include "materials/microfacet_reflection.h"
#include "materials/microfacet_transmission.h"
#include "materials/sheen.h"
#include "materials/sheen_albedo.h"
#include "numeric/color.h"

namespace vitrine {

enum class Transmission : std::uint8_t {
  kThin,    ///< a wall without thickness: light goes straight on
  kRefract  ///< the boundary of a solid
};

template <class N>
struct SheenLayer {
  Vec3<typename N::Unit> color = Vec3<typename N::Unit>(0);
  typename N::Unit roughness = typename N::Unit(0);
  const SheenAlbedo<N>* albedo = nullptr;  ///< nullptr: no sheen
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
  SheenLayer<N> sheen;
  Clearcoat<N> coat;
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
  /// wo: unit, local, wo.z > 0. `how` is what sample() and the densities follow.
  Bsdf(const SurfaceScattering<N>& surface, const Vec3<Unit>& wo,
       DirectionSampling how = DirectionSampling::kBrdfCosine)
      : surface_(surface),
        ggx_(surface.alpha),
        wo_(wo),
        how_(how),
        layered_(surface.sheen.albedo != nullptr || surface.coat.weight > 0) {
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
    reflectance_ = std::min(total, Unit(1));
    if (total > 0) {
      prob_reflect_ = reflected / total;
      prob_transmit_ = transmitted / total;
      prob_diffuse_ = 1 - prob_reflect_ - prob_transmit_;
      if (!(diffused > 0)) {  // no rest of a rounding
        prob_diffuse_ = Unit(0);
        prob_reflect_ = 1 - prob_transmit_;
      }
    }
    if (layered_) cover_base();
  }

  /// About how much of the light from wo is scattered: its luminance, at most 1.
  [[nodiscard]] Unit reflectance() const { return reflectance_; }
  /// Whether anything scatters other than by delta lobes, and whether some of it goes through.
  [[nodiscard]] bool is_rough() const {
    return prob_diffuse_ > 0 || (!surface_.smooth && prob_reflect_ + prob_transmit_ > 0) ||
           (layered_ && (prob_sheen_ > 0 || (!surface_.coat.smooth && prob_coat_ > 0)));
  }
  [[nodiscard]] bool is_rough_both_sides() const { return !surface_.smooth && prob_transmit_ > 0; }
  /// The share of samples that the delta lobes get.
  [[nodiscard]] Unit prob_delta() const {
    const Unit base = surface_.smooth ? prob_reflect_ + prob_transmit_ : Unit(0);
    return surface_.coat.smooth ? base + prob_coat_ : base;
  }

  /// The rough lobes for a local direction on either side.
  [[nodiscard]] BsdfValue<N> eval(const Vec3<Unit>& wi) const {
    BsdfValue<N> value = eval_base(wi);
    if (layered_) add_layers(wi, value);
    if (ignores_lobes()) value.pdf_w = pdf_ignoring_lobes(wi);
    return value;
  }

  /// A direction, or nothing when the light is absorbed. `choice` picks the lobe. What a rough lobe sends to
  /// the wrong side is absorbed: the density of the other side's lobes does not count it.
  [[nodiscard]] std::optional<BsdfSample<N>> sample(Unit choice, Unit u, Unit v) const {
    if (layered_) {
      const Unit prob_layers = prob_coat_ + prob_sheen_;
      if (choice < prob_layers) return sample_layers(choice, u, v);
      choice -= prob_layers;
    }
    if (choice < prob_reflect_) {
      if (surface_.smooth) return delta_reflection();
      if (!ignores_lobes()) return reflected(sample_microfacet_reflection(ggx_, wo_, u, v, how_));
    } else if (choice < prob_reflect_ + prob_transmit_) {
      if (surface_.smooth) return delta_transmission();
      if (!ignores_lobes()) return sample_transmission(u, v);
    } else if (!(prob_diffuse_ > 0)) {
      return std::nullopt;
    }
    return sample_hemisphere(u, v);
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

  // Reflection, transmission and Lambert lobe, with nothing over them.
  [[gnu::always_inline]] [[nodiscard]] BsdfValue<N> eval_base(const Vec3<Unit>& wi) const {
    BsdfValue<N> value{Vec3<Weight>(0), Density(0)};
    if (wi.z > 0) {
      if (prob_diffuse_ > 0) add(eval_lambert<N>(diffuse_left_over(wi), wi, how_), prob_diffuse_, value);
      if (prob_reflect_ > 0 && !surface_.smooth) {
        add(eval_microfacet_reflection(
                ggx_, wo_, wi, [this](Unit c) { return fresnel(c); }, how_),
            prob_reflect_, value);
      }
    } else if (wi.z < 0 && prob_transmit_ > 0 && !surface_.smooth) {
      if (surface_.transmission == Transmission::kRefract) {
        add(eval_microfacet_transmission(ggx_, surface_.transmit, surface_.eta, wo_, wi, how_),
            prob_transmit_, value);
      } else {  // the reflection lobe, turned to the other side
        const auto tint = [this](Unit c) { return surface_.transmit * (Vec3<Unit>(1) - fresnel(c)); };
        add(eval_microfacet_reflection(ggx_, wo_, Vec3<Unit>(wi.x, wi.y, -wi.z), tint, how_), prob_transmit_,
            value);
      }
    }
    return value;
  }

  static void add(const LobeValue<N>& lobe, Unit prob, BsdfValue<N>& value) {
    value.f_cos += lobe.tint * lobe.scale;
    value.pdf_w += lobe.pdf_w * prob;
  }

  // Layers are rare: out of line, they do not burden the surfaces that have none. What every surface needs is
  // inlined by force: without that, a frame took 4 % longer.

  // Shares out between the layers and the base, as far as it is seen through them.
  [[gnu::noinline]] void cover_base() {
    if (surface_.sheen.albedo != nullptr) sheen_o_ = sheen_albedo(wo_.z);
    const Unit coated = surface_.coat.reflectance(wo_.z);
    const Unit sheened = (1 - coated) * luminance<Unit>(surface_.sheen.color) * std::min(sheen_o_, Unit(1));
    const Unit total = coated + sheened + reflectance_ * left_over(wo_.z);
    reflectance_ = std::min(total, Unit(1));
    if (!(total > 0)) return;
    prob_coat_ = coated / total;
    prob_sheen_ = sheened / total;
    const Unit prob_base = 1 - prob_coat_ - prob_sheen_;
    prob_reflect_ *= prob_base;
    prob_transmit_ *= prob_base;
    prob_diffuse_ *= prob_base;
  }
  // `choice` in [0, prob_coat_ + prob_sheen_).
  [[gnu::noinline]] [[nodiscard]] std::optional<BsdfSample<N>> sample_layers(Unit choice, Unit u,
                                                                             Unit v) const {
    const bool coat = choice < prob_coat_;
    if (coat && surface_.coat.smooth) return delta_coat();
    if (ignores_lobes()) return sample_hemisphere(u, v);
    return reflected(coat ? sample_clearcoat(surface_.coat, wo_, u, v, how_) : sample_sheen<N>(u, v));
  }
  // What lies over the base, and what that leaves of it.
  [[gnu::noinline]] void add_layers(const Vec3<Unit>& wi, BsdfValue<N>& value) const {
    const Unit cos_i = abs(wi.z);
    value.f_cos = value.f_cos * left_over(cos_i);
    if (!(wi.z > 0)) return;
    if (prob_sheen_ > 0) {
      const SheenLayer<N>& sheen = surface_.sheen;
      const Unit albedo = std::max(sheen_o_, sheen_albedo(cos_i));
      const Unit dimmed = surface_.coat.left_over(wo_.z, cos_i) / std::max(albedo, Unit(1));
      add(eval_sheen(Charlie<N>(sheen.roughness), sheen.color * dimmed, wo_, wi), prob_sheen_, value);
    }
    if (prob_coat_ > 0 && !surface_.coat.smooth) {
      add(eval_clearcoat(surface_.coat, wo_, wi, how_), prob_coat_, value);
    }
  }
  [[gnu::noinline]] [[nodiscard]] Unit left_over(Unit cos_i) const {
    const Unit coat = surface_.coat.left_over(wo_.z, cos_i);
    if (surface_.sheen.albedo == nullptr) return coat;
    const Unit albedo = std::min(std::max(sheen_o_, sheen_albedo(cos_i)), Unit(1));
    return coat * (1 - max_component(surface_.sheen.color) * albedo);
  }
  [[nodiscard]] Unit sheen_albedo(Unit cosine) const {
    return (*surface_.sheen.albedo)(cosine, surface_.sheen.roughness);
  }

  // Samplings that do not care how the surface scatters, but where it does.
  [[nodiscard]] bool ignores_lobes() const {
    return how_ == DirectionSampling::kUniform || how_ == DirectionSampling::kCosine;
  }
  [[nodiscard]] Density pdf_ignoring_lobes(const Vec3<Unit>& wi) const {
    const bool both = is_rough_both_sides();
    if (!is_rough() || !(wi.z > 0 || both)) return Density(0);
    const Density rough(1 - prob_delta());
    const Density hemisphere = pdf_lambert<N>(abs(wi.z), how_);
    return both ? hemisphere * rough * Density(0.5) : hemisphere * rough;
  }
  // The Lambert lobe, or all lobes where they are ignored: then on either side that they reach.
  [[gnu::always_inline]] [[nodiscard]] std::optional<BsdfSample<N>> sample_hemisphere(Unit u, Unit v) const {
    const bool both = ignores_lobes() && is_rough_both_sides();
    const bool below = both && !(u < Unit(0.5));
    if (both) u = below ? u + u - 1 : u + u;
    Vec3<Unit> wi = sample_lambert<N>(u, v, how_);
    if (below) wi.z = -wi.z;
    return weighed(wi);
  }
  [[nodiscard]] std::optional<BsdfSample<N>> sample_transmission(Unit u, Unit v) const {
    if (surface_.transmission == Transmission::kRefract) {
      const auto wi = sample_microfacet_transmission(ggx_, surface_.eta, wo_, u, v, how_);
      return wi ? transmitted(*wi) : std::nullopt;
    }
    const Vec3<Unit> wi = sample_microfacet_reflection(ggx_, wo_, u, v, how_);
    return transmitted(Vec3<Unit>(wi.x, wi.y, -wi.z));
  }

  [[nodiscard]] std::optional<BsdfSample<N>> weighed(const Vec3<Unit>& wi) const {
    const BsdfValue<N> value = eval(wi);
    if (!(value.pdf_w > 0)) return std::nullopt;
    return BsdfSample<N>{wi, value.f_cos / value.pdf_w, value.pdf_w, false};
  }
  [[gnu::always_inline]] [[nodiscard]] std::optional<BsdfSample<N>> reflected(const Vec3<Unit>& wi) const {
    return wi.z > 0 ? weighed(wi) : std::nullopt;
  }
  [[nodiscard]] std::optional<BsdfSample<N>> transmitted(const Vec3<Unit>& wi) const {
    return wi.z < 0 ? weighed(wi) : std::nullopt;
  }

  [[nodiscard]] std::optional<BsdfSample<N>> delta_reflection() const {
    return delta(mirrored(), fresnel(wo_.z), prob_reflect_);
  }
  [[nodiscard]] std::optional<BsdfSample<N>> delta_transmission() const {
    const Vec3<Unit> tint = surface_.transmit * (Vec3<Unit>(1) - fresnel(wo_.z));
    if (surface_.transmission == Transmission::kThin) return delta(-wo_, tint, prob_transmit_);
    const Unit cos_t = fresnel_dielectric(wo_.z, surface_.eta).cos_t;
    if (!(cos_t > 0)) return std::nullopt;
    const Vec3<Unit> normal(Unit(0), Unit(0), Unit(1));
    BsdfSample<N> sample = delta(refract(wo_, normal, wo_.z, cos_t, surface_.eta), tint, prob_transmit_);
    sample.weight = sample.weight / Weight(square(surface_.eta));
    return sample;
  }
  [[nodiscard]] std::optional<BsdfSample<N>> delta_coat() const {
    const Unit tint = surface_.coat.reflectance(wo_.z);
    return BsdfSample<N>{mirrored(), Vec3<Weight>(Weight(tint)) / Weight(prob_coat_), Density(1), true};
  }
  // Of the base: what the layers over it leave.
  [[nodiscard]] BsdfSample<N> delta(const Vec3<Unit>& wi, Vec3<Unit> tint, Unit prob) const {
    if (layered_) tint = tint * left_over(abs(wi.z));
    const Vec3<Weight> weight = Vec3<Weight>(Weight(tint.x), Weight(tint.y), Weight(tint.z)) / Weight(prob);
    return {wi, weight, Density(1), true};
  }
  [[nodiscard]] Vec3<Unit> mirrored() const { return Vec3<Unit>(-wo_.x, -wo_.y, wo_.z); }

  SurfaceScattering<N> surface_;
  Ggx<N> ggx_;
  Vec3<Unit> wo_;
  DirectionSampling how_;
  bool layered_;  // there is a sheen or a coat
  bool has_specular_ = false;
  bool exact_fresnel_ = false;
  Unit prob_reflect_ = Unit(0);
  Unit prob_transmit_ = Unit(0);
  Unit prob_coat_ = Unit(0);
  Unit prob_sheen_ = Unit(0);
  Unit prob_diffuse_ = Unit(0);
  Unit reflectance_ = Unit(0);
  Unit sheen_o_ = Unit(0);  // the sheen's albedo as wo sees it
};

}  // namespace vitrine
