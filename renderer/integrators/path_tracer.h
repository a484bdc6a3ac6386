// Unidirectional path tracing: from the eye, one scattering event after the other. How directions are found,
// how light is collected and when a path ends are parts that the mode names. Lecture: "Basic Path Tracing",
// "PT Pseudocode".
//
//   L = Le + 1/b sum over b directions of f cos / pdf * L(next)            basic
//   L = Ld + 1/b sum over b directions of f cos / pdf * (L - Le)(next)     with next event estimation
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "integrators/direct_light.h"
#include "integrators/path.h"
#include "integrators/sampling_parts.h"
#include "integrators/surface_vertex.h"
#include "scene/camera.h"
#include "scene/world.h"

namespace vitrine {

template <class N>
class PathTracer {
  using Unit = typename N::Unit;
  using Density = typename N::Density;
  using Weight = typename N::Weight;

 public:
  /// `max_depth`: scattering events that a path may have whatever its stopping rule.
  PathTracer(const World<N>& world, const SamplingParts& parts, int max_depth)
      : world_(world),
        direction_(parts.direction),
        direct_light_(world, parts),
        roulette_(parts.stop),
        radiance_samples_(static_cast<std::uint16_t>(parts.radiance_samples)),
        radiance_sample_count_(N::density_from_count(radiance_samples_)),
        max_depth_(static_cast<std::uint32_t>(parts.stop.kind == StoppingRule::Kind::kFixedDepth
                                                  ? std::min(max_depth, parts.stop.depth)
                                                  : max_depth)) {}

  /// The most paths of one sample that are under way at once.
  [[nodiscard]] std::size_t max_branches() const { return radiance_samples_ > 1 ? kMaxBranches : 1; }

  /// Begins a path through pixel (x, y).
  template <Asks<N> A>
  void begin(const Camera<N>& camera, std::uint32_t x, std::uint32_t y, const Sampler& sampler,
             std::uint32_t slot, A& asks) const {
    Path<N> path{.beta = Vec3<Weight>(1),
                 .pdf_w = Density(1),
                 .last = {},
                 .sampler = sampler,
                 .slot = slot,
                 .depth = 0,
                 .solid = kOutside,
                 .branch = 1,
                 .only_way = true};
    path.sampler.seek(kCameraDimension);
    const Unit u = path.sampler.template next<N>();
    const Unit v = path.sampler.template next<N>();
    asks.go_on(path, camera.ray(x, y, u, v));
  }

  /// Tells the path what its ray met.
  template <Asks<N> A>
  void advance(const Path<N>& path, const Ray<N>& ray, const Hit<N>& hit, A& asks) const {
    if (world_.absorbs) {
      arrive(absorbed(path, ray, hit), ray, hit, asks);
    } else {
      arrive(path, ray, hit, asks);
    }
  }

 private:
  /// Splitting at every vertex grows without bound: a sample's paths are split up to this many.
  static constexpr std::size_t kMaxBranches = 256;

  template <class A>
  void arrive(const Path<N>& path, const Ray<N>& ray, const Hit<N>& hit, A& asks) const {
    direct_light_.add_met(path, ray, hit, asks);
    if (!hit || path.depth >= max_depth_) return;
    const SurfaceVertex<N> vertex(world_, ray, hit, direction_);
    const bool splits = path.branch * radiance_samples_ <= kMaxBranches;
    const Density directions = splits ? radiance_sample_count_ : Density(1);
    direct_light_.add_sampled(path, vertex, directions, asks);
    const std::uint16_t count = splits ? radiance_samples_ : std::uint16_t{1};
    for (std::uint16_t i = 0; i < count; ++i) scatter(path, vertex, i, count, directions, asks);
  }

  // What meets the back of a solid has come through it, whatever the path remembers: the camera may be
  // inside, and one solid within another.
  [[nodiscard]] Path<N> absorbed(Path<N> path, const Ray<N>& ray, const Hit<N>& hit) const {
    if (hit && world_.material(hit.triangle).solid) {
      const auto& info = world_.triangles[hit.triangle];
      if (dot(ray.direction, info.normal) > 0) path.solid = info.material;
    }
    path.beta = path.beta * world_.transmittance(path.solid, hit.t);
    return path;
  }

  // Goes on in the i-th of `count` directions.
  template <class A>
  void scatter(const Path<N>& path, const SurfaceVertex<N>& vertex, std::uint16_t i, std::uint16_t count,
               Density directions, A& asks) const {
    Sampler sampler = path.sampler;
    sampler.seek(scatter_dimension(path.depth));
    if (count > 1) sampler = sampler.split(i, count);
    const Unit u = sampler.template next<N>();
    const Unit v = sampler.template next<N>();
    const Unit choice = sampler.template next<N>();
    const Unit survival = sampler.template next<N>();
    const std::optional<BsdfSample<N>> sample = vertex.bsdf().sample(choice, u, v);
    if (!sample) return;
    const Vec3<Unit> wi = normalize(vertex.to_world(sample->wi));
    if (!vertex.sides_agree(wi, sample->wi)) return;
    Vec3<Weight> beta = path.beta * sample->weight;
    if (count > 1) beta = beta / directions;
    if (!(max_component(beta) > 0)) return;
    const std::uint32_t depth = path.depth + 1;
    const Unit prob = roulette_.prob(depth, vertex.bsdf().reflectance(), beta);
    if (prob < 1) {
      if (!(survival < prob)) return;
      beta = beta / Weight(prob);
    }
    asks.go_on(Path<N>{.beta = beta,
                       .pdf_w = sample->pdf_w * directions,
                       .last = vertex.receiver(),
                       .sampler = sampler,
                       .slot = path.slot,
                       .depth = depth,
                       .solid = vertex.solid_towards(sample->wi, path.solid),
                       .branch = static_cast<std::uint16_t>(path.branch * count),
                       .only_way = sample->delta},
               vertex.ray_along(wi));
  }

  const World<N>& world_;
  DirectionSampling direction_;
  DirectLightEstimator<N> direct_light_;
  Roulette<N> roulette_;
  std::uint16_t radiance_samples_;
  Density radiance_sample_count_;
  std::uint32_t max_depth_;
};

}  // namespace vitrine
