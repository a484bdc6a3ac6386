// A picture in the making: a renderer's film, exposed pass by pass. Each pass adds samples to every pixel,
// tile by tile, on all workers, while the caller goes on. Offline renders and the kiosk both make their
// pictures here.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "buttons.h"
#include "film/film.h"
#include "frame/renderer.h"
#include "frame/views.h"
#include "workers.h"

namespace vitrine {

/// Display-referred sRGB: 3 bytes a pixel, rows top to bottom.
struct DevelopedPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

class Picture {
 public:
  /// `workers` must outlive the picture and do nothing else during a pass.
  Picture(std::unique_ptr<const Renderer> renderer, Workers& workers);
  /// Cancels the pass under way.
  ~Picture();
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;

  /// Begins a pass of `samples` more samples a pixel and returns at once. The last pass must have ended.
  void start_pass(std::uint32_t samples);
  /// Whether the pass under way has ended within `timeout`. Throws what the renderer has thrown.
  bool pass_ended(std::chrono::milliseconds timeout);
  /// Waits for the end of the pass.
  void finish_pass();
  /// Lets the pass under way, if any, end soon and unfinished; the picture is of no use any more.
  void abandon();
  /// The part of the pass under way that is done, 0 to 1.
  [[nodiscard]] double progress() const;

  // Between passes:

  /// Samples a pixel of the passes that ended.
  [[nodiscard]] std::uint32_t samples() const { return samples_; }
  [[nodiscard]] const TraceStats& stats() const { return stats_; }
  /// How long the workers were at the last pass.
  [[nodiscard]] Clock::duration pass_time() const { return tile_ended_ - pass_began_; }
  [[nodiscard]] const Film& film() const { return film_; }
  [[nodiscard]] Exposure meter() const { return renderer_->meter(film_); }
  /// The relative error that the picture is estimated to have, 1 being 100 %; on all workers.
  [[nodiscard]] std::optional<double> error() const;
  /// Develops a view of the film into `developed`, on all workers.
  void develop(const View& view, Exposure exposure, DevelopedPicture& developed) const;

 private:
  void end_pass();

  std::unique_ptr<const Renderer> renderer_;
  Workers& workers_;
  Film film_;
  std::vector<Tile> tiles_;
  std::uint32_t samples_ = 0;
  std::uint32_t pass_samples_ = 0;  ///< of the pass under way; 0 between passes
  std::atomic<std::size_t> tiles_done_{0};
  Clock::time_point pass_began_;
  std::mutex tile_mutex_;  // of what a tile that ends adds to:
  TraceStats stats_;
  Clock::time_point tile_ended_;
};

}  // namespace vitrine
