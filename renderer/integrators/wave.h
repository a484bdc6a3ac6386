// A wave: samples that advance together, stage by stage - trace all, shade all, test all shadows - so that
// the kernels see batches. The wave driver fills it with thousands of samples, the path driver with a single
// one; either way each sample's light is added in the same order, so both give the same picture, bit for bit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "integrators/path.h"
#include "scene/world.h"

namespace vitrine {

template <class N>
class Wave {
  using Radiance = typename N::Radiance;

 public:
  /// Forgets everything and makes room for `samples` samples, whose slots are 0, 1, ...
  void reset(std::size_t samples) {
    radiance_.assign(samples, Vec3<Radiance>(0));
    next_.clear();
  }

  /// One stage for every path that is under way. False: none was.
  template <class Estimator>
  bool advance(const Estimator& estimator, const World<N>& world) {
    if (next_.paths.empty()) return false;
    std::swap(current_, next_);
    next_.clear();
    hits_.resize(current_.rays.size());
    world.bvh.closest(current_.rays, hits_);
    for (std::size_t i = 0; i < hits_.size(); ++i) {
      estimator.advance(current_.paths[i], current_.rays[i], hits_[i], *this);
    }
    rays_traced_ += hits_.size() + shadows_.rays.size();
    test_shadows(world);
    return true;
  }

  [[nodiscard]] const Vec3<Radiance>& radiance(std::size_t slot) const { return radiance_[slot]; }
  [[nodiscard]] std::uint64_t rays_traced() const { return rays_traced_; }

  // What an estimator asks (see Asks).
  void found(const Path<N>& path, const Vec3<Radiance>& L) { radiance_[path.slot] += L; }
  void shadow(const Path<N>& path, const Ray<N>& ray, const Vec3<Radiance>& L) {
    shadows_.rays.push_back(ray);
    shadows_.worth.push_back({L, path.slot});
  }
  void go_on(const Path<N>& path, const Ray<N>& ray) {
    next_.paths.push_back(path);
    next_.rays.push_back(ray);
  }

 private:
  struct Front {
    std::vector<Path<N>> paths;
    std::vector<Ray<N>> rays;
    void clear() {
      paths.clear();
      rays.clear();
    }
  };
  struct Worth {
    Vec3<Radiance> L;
    std::uint32_t slot;
  };
  struct Shadows {
    std::vector<Ray<N>> rays;
    std::vector<Worth> worth;
    std::vector<std::uint8_t> occluded;
  };

  void test_shadows(const World<N>& world) {
    shadows_.occluded.resize(shadows_.rays.size());
    world.bvh.occluded(shadows_.rays, shadows_.occluded);
    for (std::size_t i = 0; i < shadows_.worth.size(); ++i) {
      if (shadows_.occluded[i] == 0) radiance_[shadows_.worth[i].slot] += shadows_.worth[i].L;
    }
    shadows_.rays.clear();
    shadows_.worth.clear();
  }

  Front current_;
  Front next_;
  std::vector<Hit<N>> hits_;
  Shadows shadows_;
  std::vector<Vec3<Radiance>> radiance_;
  std::uint64_t rays_traced_ = 0;
};

}  // namespace vitrine
