// A wave: samples that advance together, stage by stage - trace all, shade all, test all shadows - so that
// the kernels see batches. The wave driver fills it with thousands of samples, the path driver with a single
// one; either way each sample's light is added in the same order, so both give the same picture, bit for bit.
#pragma once

#include <atomic>
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

  /// One stage for every path that is under way. False: none was, or `cancel` became true.
  template <class Estimator>
  bool advance(const Estimator& estimator, const World<N>& world, const std::atomic<bool>& cancel) {
    if (next_.paths.empty() || cancel.load(std::memory_order_relaxed)) return false;
    std::swap(current_, next_);
    next_.clear();
    hits_.resize(current_.rays.size());
    world.closest(current_.rays, hits_);
    rays_traced_ += hits_.size();
    for (std::size_t i = 0; i < hits_.size(); ++i) {
      // Not between the paths of one sample, which stand together: its light is to be added in one order.
      if (shadows_.rays.size() >= kShadowBatch && current_.paths[i].slot != current_.paths[i - 1].slot) {
        test_shadows(world);
        if (cancel.load(std::memory_order_relaxed)) return false;
      }
      estimator.advance(current_.paths[i], current_.rays[i], hits_[i], *this);
    }
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

  /// Shadow rays that are enough for a batch: with hundreds a vertex, a whole stage of them would take too
  /// much memory and too long to cancel.
  static constexpr std::size_t kShadowBatch = 8192;

  void test_shadows(const World<N>& world) {
    rays_traced_ += shadows_.rays.size();
    shadows_.occluded.resize(shadows_.rays.size());
    world.occluded(shadows_.rays, shadows_.occluded);
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
