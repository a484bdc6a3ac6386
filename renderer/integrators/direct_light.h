// Light that comes straight from a source to a path's vertex: found by shadow rays (next event estimation),
// by chance (a scattered ray meets the source), or by both with weights that add up to 1. Lecture: "PT
// Pseudocode
// - Direct Illumination", with the visibility V tested by the driver.
//
//   Ld = 1/n sum over n shadow rays of Le f cos V / (prob(light) pdf_w),    pdf_w = pdf_a d^2 / cos_light
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "integrators/dimensions.h"
#include "integrators/path.h"
#include "integrators/sampling_parts.h"
#include "integrators/surface_vertex.h"
#include "sampling/mis.h"
#include "scene/world.h"

namespace vitrine {

template <class N>
class DirectLightEstimator {
  using Unit = typename N::Unit;
  using Density = typename N::Density;
  using Weight = typename N::Weight;
  using Radiance = typename N::Radiance;

 public:
  DirectLightEstimator(const World<N>& world, const SamplingParts& parts)
      : world_(world),
        direct_(parts.direct),
        lights_(parts.lights),
        light_points_(parts.light_points),
        heuristic_(parts.heuristic),
        rays_(rays_to_each_choice(parts, world.lights.size())),
        ray_count_(N::density_from_count(rays_)) {}

  /// What the path's ray met: a source, or the environment where it left the scene.
  template <class A>
  void add_met(const Path<N>& path, const Ray<N>& ray, const Hit<N>& hit, A& asks) const {
    if (hit) {
      add_emission(path, ray, hit, asks);
    } else {
      add_sky(path, ray, asks);
    }
  }

  /// What shadow rays from `vertex` find, where the path goes on in `directions` directions.
  template <class A>
  void add_sampled(const Path<N>& path, const SurfaceVertex<N>& vertex, Density directions, A& asks) const {
    const std::uint32_t count = world_.lights.size();
    if (direct_ == DirectLight::kByChance || count == 0 || !vertex.bsdf().is_rough()) return;
    const Receiver<N> receiver = vertex.receiver();
    Sampler sampler = path.sampler;
    sampler.seek(light_dimension(path.depth));
    if (lights_ == LightSelection::kAll) {
      for (std::uint32_t i = 0; i < rays_ * count; ++i) {
        Sampler one = sampler.split(i, rays_ * count);
        one.next_bits();  // no light to choose
        add_shadow_ray(path, vertex, directions, {i / rays_, Density(1)}, draw(one), asks);
      }
      return;
    }
    for (std::uint32_t i = 0; i < rays_; ++i) {
      Sampler one = sampler.split(i, rays_);
      const std::uint32_t choice = one.next_bits();
      if (const auto chosen = world_.light_selectors.select(lights_, receiver, choice)) {
        add_shadow_ray(path, vertex, directions, *chosen, draw(one), asks);
      }
    }
  }

 private:
  /// What chooses a point of a light.
  struct Draw {
    std::uint32_t bits;
    Unit u;
    Unit v;
  };
  static Draw draw(Sampler& sampler) {
    const std::uint32_t bits = sampler.next_bits();
    const Unit u = sampler.template next<N>();
    const Unit v = sampler.template next<N>();
    return {bits, u, v};
  }

  static std::uint32_t rays_to_each_choice(const SamplingParts& parts, std::uint32_t lights) {
    const auto rays = static_cast<std::uint32_t>(parts.shadow_rays);
    return parts.lights == LightSelection::kAll && lights > 0 ? std::max(1U, rays / lights) : rays;
  }

  template <class A>
  void add_sky(const Path<N>& path, const Ray<N>& ray, A& asks) const {
    const auto& sky = world_.lights.sky;
    if (!sky) return;
    const Unit weight =
        weight_by_chance(path, world_.lights.sky_index(), [&] { return sky->pdf_w(ray.direction); });
    if (weight > 0) asks.found(path, path.beta * sky->radiance(ray.direction) * weight);
  }

  template <class A>
  void add_emission(const Path<N>& path, const Ray<N>& ray, const Hit<N>& hit, A& asks) const {
    const auto& info = world_.triangles[hit.triangle];
    if (info.light == kNoLight) return;
    const MeshLight<N>& light = world_.lights.meshes[info.light];
    if (!light.shines(info.light_triangle, ray.direction)) return;
    const Unit weight = weight_by_chance(path, info.light, [&] {
      return light.pdf_w(light_points_, info.light_triangle, path.last.position, ray.direction, hit.t);
    });
    if (weight > 0) asks.found(path, path.beta * world_.emitted(hit.triangle, hit.u, hit.v) * weight);
  }

  // What a light that a scattered ray met counts, where a shadow ray would have found the point with density
  // `pdf_w()`, were this the light it went to.
  template <class PdfW>
  [[nodiscard]] Unit weight_by_chance(const Path<N>& path, std::uint32_t light, const PdfW& pdf_w) const {
    if (path.only_way || direct_ == DirectLight::kByChance) return Unit(1);
    if (direct_ == DirectLight::kNextEvent) return Unit(0);
    const Density prob = world_.light_selectors.prob(lights_, path.last, light);
    return mis_weight<N>(heuristic_, path.pdf_w, ray_count_ * prob * pdf_w());
  }

  template <class A>
  void add_shadow_ray(const Path<N>& path, const SurfaceVertex<N>& vertex, Density directions,
                      const SelectedLight<N>& chosen, const Draw& draw, A& asks) const {
    const auto light =
        world_.lights.sample(chosen.light, light_points_, vertex.position(), draw.bits, draw.u, draw.v);
    if (!light) return;
    const Vec3<Unit> wi = vertex.to_local(light->wi);
    if (!vertex.sides_agree(light->wi, wi)) return;
    const BsdfValue<N> f = vertex.bsdf().eval(wi);
    if (!(max_component(f.f_cos) > 0)) return;
    const Density density = ray_count_ * chosen.prob * light->pdf_w;
    Weight weight = Weight(1) / density;
    if (direct_ == DirectLight::kMis && !light->delta) {
      weight = weight * mis_weight<N>(heuristic_, density, f.pdf_w * directions);
    }
    const Vec3<Radiance> radiance =
        light->triangle == kNoTriangle
            ? light->radiance
            : world_.emitted(light->triangle, light->barycentric.x, light->barycentric.y) *
                  world_.coverage(light->triangle, light->barycentric.x, light->barycentric.y);
    Vec3<Radiance> L = path.beta * f.f_cos * radiance * weight;
    const std::optional<Ray<N>> ray =
        light->end ? vertex.ray_to(*light->end, light->wi) : vertex.ray_along(light->wi);
    if (ray) {
      if (world_.absorbs) L = L * world_.transmittance(vertex.solid_towards(wi, path.solid), ray->t_max);
      asks.shadow(path, *ray, L);
    } else {
      asks.found(path, L);
    }
  }

  const World<N>& world_;
  DirectLight direct_;
  LightSelection lights_;
  LightPoints light_points_;
  MisHeuristic heuristic_;
  std::uint32_t rays_;  ///< to each choice of a light
  Density ray_count_;
};

}  // namespace vitrine
