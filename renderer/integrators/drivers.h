// The two drivers. Both take the samples of a tile in the same order; the wave driver some thousand at a
// time, the path driver (for tests, replays and tiny machines) each to its end.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <optional>

#include "film/film.h"
#include "integrators/trace_stats.h"
#include "integrators/wave.h"
#include "scene/camera.h"

namespace vitrine {

/// What a film can hold of a sample's radiance, or nothing if it is not finite or out of range.
template <class N>
std::optional<FilmValue> film_value(const Vec3<typename N::Radiance>& L) {
  const auto r = N::to_film(L.x, kFilmBits, kFilmSampleLimit);
  const auto g = N::to_film(L.y, kFilmBits, kFilmSampleLimit);
  const auto b = N::to_film(L.z, kFilmBits, kFilmSampleLimit);
  if (!r || !g || !b) return std::nullopt;
  return FilmValue(*r, *g, *b);
}

/// Traces `samples` of the tile's pixels in waves of at most `wave_size` paths and adds each wave to `film`
/// when it is complete. After `cancel` it returns soon, and the wave under way is lost.
template <class N, class Estimator>
TraceStats drive(const Estimator& estimator, const World<N>& world, const Camera<N>& camera,
                 Sequence sequence, std::uint64_t seed, const Tile& tile, SampleRange samples,
                 std::size_t wave_size, Film& film, const std::atomic<bool>& cancel) {
  struct Origin {
    int x;
    int y;
    std::uint32_t sample;
  };
  const auto origin_of = [&](std::uint64_t index) {
    const std::uint64_t pixel = index / samples.count;
    const auto width = static_cast<std::uint64_t>(tile.width());
    return Origin{tile.x0 + static_cast<int>(pixel % width), tile.y0 + static_cast<int>(pixel / width),
                  samples.first + static_cast<std::uint32_t>(index % samples.count)};
  };
  const std::uint64_t total =
      static_cast<std::uint64_t>(tile.width()) * static_cast<std::uint64_t>(tile.height()) * samples.count;
  TraceStats stats;
  Wave<N> wave;
  const std::size_t most = std::max<std::size_t>(1, wave_size / estimator.max_branches());
  for (std::uint64_t begin = 0; begin < total; begin += most) {
    const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(most, total - begin));
    wave.reset(count);
    for (std::uint32_t slot = 0; slot < count; ++slot) {
      const Origin origin = origin_of(begin + slot);
      const auto x = static_cast<std::uint32_t>(origin.x);
      const auto y = static_cast<std::uint32_t>(origin.y);
      estimator.begin(camera, x, y, Sampler(sequence, seed, x, y, origin.sample), slot, wave);
    }
    while (wave.advance(estimator, world, cancel)) {
    }
    if (cancel.load(std::memory_order_relaxed)) {
      stats.cancelled = true;
      break;
    }
    for (std::uint32_t slot = 0; slot < count; ++slot) {
      const Origin origin = origin_of(begin + slot);
      if (const auto value = film_value<N>(wave.radiance(slot))) {
        film.add(origin.x, origin.y, *value);
      } else {
        stats.drop({origin.x, origin.y, origin.sample, seed});
      }
    }
    stats.samples += count;
  }
  stats.rays = wave.rays_traced();
  return stats;
}

}  // namespace vitrine
