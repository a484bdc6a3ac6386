// What an estimator remembers of a path that is under way, and the words in which it asks its driver for
// more.
#pragma once

#include <concepts>
#include <cstdint>

#include "geometry/ray.h"
#include "lights/light_selection.h"
#include "sampling/sampler.h"
#include "scene/world.h"

namespace vitrine {

template <class N>
struct Path {
  Vec3<typename N::Weight> beta;  ///< throughput: what light found next is multiplied by
  typename N::Density pdf_w;      ///< of the last direction times how many were taken with it, 1/sr
  Receiver<N> last;               ///< the vertex it was scattered at
  Sampler sampler;
  std::uint32_t slot;    ///< which of the driver's samples the path adds to
  std::uint32_t depth;   ///< scattering events so far
  std::uint32_t solid;   ///< that the ray is in, by its material; kOutside
  std::uint16_t branch;  ///< into how many the sample's path has been split up to here
  bool only_way;         ///< no shadow ray could have found what this ray finds (camera, mirror)
};

/// The driver's side of the talk. An estimator never traces: it is told a hit and asks.
template <class A, class N>
concept Asks = requires(A& asks, const Path<N>& path, const Ray<N>& ray,
                        const Vec3<typename N::Radiance>& L) {
  asks.found(path, L);        ///< light that belongs to the path's sample
  asks.shadow(path, ray, L);  ///< the same, if nothing is in the way of `ray`
  asks.go_on(path, ray);      ///< trace `ray` and tell the estimator; a path may go on more than once
};

}  // namespace vitrine
