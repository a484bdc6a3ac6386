// The Renderer of one number system: joins camera, estimator, driver, meter and tone map. Every operation
// between the first random number and the film happens in what this header instantiates.
#pragma once

#include <memory>

#include "frame/renderer.h"
#include "frame/tone_map.h"
#include "integrators/drivers.h"
#include "integrators/path_tracer.h"
#include "scene/bake.h"

namespace vitrine {

template <class N>
class TileRenderer final : public Renderer {
 public:
  /// The display curve is made by the host, so it is handed in.
  TileRenderer(const World<N>& world, const Camera<N>& camera, const RenderOptions& options,
               const DisplayCurve& curve)
      : world_(world),
        camera_(camera),
        options_(options),
        path_tracer_(world, options.sampling(), options.max_depth),
        curve_(curve) {}

  [[nodiscard]] Film make_film() const override { return {options_.width, options_.height, world_.exponent}; }

  TraceStats trace(const Tile& tile, SampleRange samples, Film& film,
                   const std::atomic<bool>& cancel) const override {
    const std::size_t wave_size =
        options_.driver == Driver::kPath ? 1 : static_cast<std::size_t>(options_.wave_size);
    return drive<N>(path_tracer_, world_, camera_, options_.sampling().sequence, options_.seed, tile, samples,
                    wave_size, film, cancel);
  }

  [[nodiscard]] Exposure meter(const Film& film) const override { return meter_film<N>(film); }

  void develop(const Film& film, const Tile& tile, Exposure exposure, std::uint8_t* rgb) const override {
    const typename N::Density factor = exposure_factor<N>(exposure, film.exponent());
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        const DisplayCode codes = tone_map<N>(film.at(x, y), factor, curve_);
        std::uint8_t* out = rgb + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width()) +
                                       static_cast<std::size_t>(x));
        std::copy(codes.begin(), codes.end(), out);
      }
    }
  }

 private:
  const World<N>& world_;
  Camera<N> camera_;
  RenderOptions options_;
  PathTracer<N> path_tracer_;
  const DisplayCurve& curve_;
};

/// Instantiated once a number system, in a file of its own: the fixed one must hold no floating-point
/// operation.
template <class N>
std::unique_ptr<Renderer> make_tile_renderer(const World<N>& world, const Camera<N>& camera,
                                             const RenderOptions& options, const DisplayCurve& curve);

}  // namespace vitrine
