// Unidirectional path tracing: from the eye, one scattering event after the other. How directions are found
// and how light is collected are parts that the mode names. Lecture: "Basic Path Tracing", "Next Event
// Estimation".
//
//   L = Le + f cos / pdf * L(next)                       basic
//   L = Ld + f cos / pdf * (L - Le)(next)                with next event estimation: Le counts by shadow rays
#pragma once

#include <cstdint>
#include <optional>

#include "integrators/direction_sampling.h"
#include "integrators/modes.h"
#include "integrators/path.h"
#include "integrators/russian_roulette.h"
#include "integrators/surface_vertex.h"
#include "sampling/mis.h"
#include "scene/camera.h"
#include "scene/world.h"

namespace vitrine {

template <class N>
class PathTracer {
  using Unit = typename N::Unit;
  using Density = typename N::Density;
  using Weight = typename N::Weight;
  using Radiance = typename N::Radiance;

 public:
  PathTracer(const World<N>& world, const Mode& mode, int max_depth)
      : world_(world), direction_(mode.direction), direct_(mode.direct), max_depth_(max_depth) {}

  /// Begins a path through pixel (x, y).
  template <Asks<N> A>
  void begin(const Camera<N>& camera, std::uint32_t x, std::uint32_t y, const Sampler& sampler,
             std::uint32_t slot, A& asks) const {
    Path<N> path{.beta = Vec3<Weight>(1),
                 .pdf_w = Density(1),
                 .sampler = sampler,
                 .slot = slot,
                 .depth = 0,
                 .only_way = true};
    const Unit u = path.sampler.template next<N>();
    const Unit v = path.sampler.template next<N>();
    asks.go_on(path, camera.ray(x, y, u, v));
  }

  /// Tells the path what its ray met.
  template <Asks<N> A>
  void advance(Path<N> path, const Ray<N>& ray, const Hit<N>& hit, A& asks) const {
    if (!hit) {
      add_sky(path, ray, asks);
      return;
    }
    add_emission(path, ray, hit, asks);
    if (path.depth >= max_depth_) return;
    const SurfaceVertex<N> vertex(world_, ray, hit);
    if (direct_ != DirectLight::kByChance && vertex.bsdf().is_rough()) add_direct_light(path, vertex, asks);
    scatter(path, vertex, asks);
  }

 private:
  template <class A>
  void add_sky(const Path<N>& path, const Ray<N>& ray, A& asks) const {
    if (!world_.lights.sky) return;
    const Unit weight = weight_by_chance(
        path, [&] { return Sky<N>::pdf_w() * world_.light_selection.prob(world_.lights.sky_index()); });
    if (weight > 0) asks.found(path, path.beta * world_.lights.sky->radiance(ray.direction) * weight);
  }

  template <class A>
  void add_emission(const Path<N>& path, const Ray<N>& ray, const Hit<N>& hit, A& asks) const {
    const auto& info = world_.triangles[hit.triangle];
    if (info.light == kNoLight) return;
    const MeshLight<N>& light = world_.lights.meshes[info.light];
    const Density pdf_w = light.pdf_w(info.light_triangle, ray.direction, hit.t);
    if (!(pdf_w > 0)) return;  // seen from behind
    const Unit weight =
        weight_by_chance(path, [&] { return pdf_w * world_.light_selection.prob(info.light); });
    if (weight > 0) asks.found(path, path.beta * world_.emitted(hit.triangle, hit.u, hit.v) * weight);
  }

  // What a source that a scattered ray met counts, where a shadow ray would have found it with density
  // `pdf_light()`.
  template <class PdfLight>
  [[nodiscard]] Unit weight_by_chance(const Path<N>& path, const PdfLight& pdf_light) const {
    if (path.only_way || direct_ == DirectLight::kByChance) return Unit(1);
    if (direct_ == DirectLight::kNextEvent) return Unit(0);
    return power_heuristic<N>(path.pdf_w, pdf_light());
  }

  template <class A>
  void add_direct_light(Path<N>& path, const SurfaceVertex<N>& vertex, A& asks) const {
    // Always the same five numbers, whatever the light.
    const std::uint32_t choice = path.sampler.next_bits();
    const std::uint32_t bits = path.sampler.next_bits();
    const std::uint32_t alias_bits = path.sampler.next_bits();
    const Unit u = path.sampler.template next<N>();
    const Unit v = path.sampler.template next<N>();
    if (world_.lights.size() == 0) return;
    const std::uint32_t chosen = world_.light_selection.sample(choice);
    const auto light = world_.lights.sample(chosen, vertex.position(), bits, alias_bits, u, v);
    if (!light) return;
    const Vec3<Unit> wi = vertex.to_local(light->wi);
    if (!vertex.sides_agree(light->wi, wi)) return;
    const BsdfValue<N> f = vertex.bsdf().eval(wi);
    if (!(max_component(f.f_cos) > 0)) return;
    const Density pdf_w = light->pdf_w * world_.light_selection.prob(chosen);
    Weight weight = Weight(1) / pdf_w;
    if (direct_ == DirectLight::kMis && !light->delta) weight = weight * power_heuristic<N>(pdf_w, f.pdf_w);
    const Vec3<Radiance> radiance =
        light->triangle == kNoTriangle
            ? light->radiance
            : world_.emitted(light->triangle, light->barycentric.x, light->barycentric.y);
    const Vec3<Radiance> L = path.beta * f.f_cos * radiance * weight;
    const std::optional<Ray<N>> ray =
        light->end ? vertex.ray_to(*light->end, light->wi) : vertex.ray_along(light->wi);
    if (ray) {
      asks.shadow(path, *ray, L);
    } else {
      asks.found(path, L);
    }
  }

  template <class A>
  void scatter(Path<N>& path, const SurfaceVertex<N>& vertex, A& asks) const {
    const Unit choice = path.sampler.template next<N>();
    const Unit u = path.sampler.template next<N>();
    const Unit v = path.sampler.template next<N>();
    const Unit survival = path.sampler.template next<N>();
    const std::optional<BsdfSample<N>> sample = sample_direction(direction_, vertex.bsdf(), choice, u, v);
    if (!sample) return;
    const Vec3<Unit> wi = normalize(vertex.to_world(sample->wi));
    if (!vertex.sides_agree(wi, sample->wi)) return;
    path.beta = path.beta * sample->weight;
    path.pdf_w = sample->pdf_w;
    path.only_way = sample->delta;
    ++path.depth;
    if (!(max_component(path.beta) > 0)) return;
    if (path.depth >= kFirstRoulette) {
      const Unit prob = roulette_prob<N>(path.beta);
      if (!(survival < prob)) return;
      path.beta = path.beta / Weight(prob);
    }
    asks.go_on(path, vertex.ray_along(wi));
  }

  const World<N>& world_;
  DirectionSampling direction_;
  DirectLight direct_;
  int max_depth_;
};

}  // namespace vitrine
