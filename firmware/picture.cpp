#include "picture.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "frame/error_estimate.h"
#include "numeric/host_conversion.h"

namespace vitrine {
namespace {

/// Small enough that the last tiles keep all threads busy and a press is answered soon, large enough that a
/// sample a pixel makes a wave of a thousand.
constexpr int kTileSize = 32;

std::vector<Tile> cut_into_tiles(int width, int height) {
  std::vector<Tile> tiles;
  for (int y = 0; y < height; y += kTileSize) {
    for (int x = 0; x < width; x += kTileSize) {
      tiles.push_back({x, y, std::min(x + kTileSize, width), std::min(y + kTileSize, height)});
    }
  }
  return tiles;
}

}  // namespace

Picture::Picture(std::unique_ptr<const Renderer> renderer, Workers& workers)
    : renderer_(std::move(renderer)),
      workers_(workers),
      film_(renderer_->make_film()),
      tiles_(cut_into_tiles(film_.width(), film_.height())) {}

Picture::~Picture() {
  if (pass_samples_ > 0) workers_.cancel();
}

void Picture::start_pass(std::uint32_t samples) {
  pass_samples_ = samples;
  tiles_done_ = 0;
  pass_began_ = Clock::now();
  workers_.start(tiles_.size(), [this, range = SampleRange{samples_, samples}](std::size_t i) {
    const TraceStats traced = renderer_->trace(tiles_[i], range, film_, workers_.cancelled());
    const std::lock_guard lock(tile_mutex_);
    stats_ += traced;
    tile_ended_ = Clock::now();
    ++tiles_done_;
  });
}

bool Picture::pass_ended(std::chrono::milliseconds timeout) {
  if (!workers_.wait_for(timeout)) return false;
  end_pass();
  return true;
}

void Picture::finish_pass() {
  workers_.wait();
  end_pass();
}

void Picture::abandon() {
  if (pass_samples_ > 0) workers_.ask_to_cancel();
}

void Picture::end_pass() {
  samples_ += std::exchange(pass_samples_, 0);
  // Tiles end in any order; the records of a render must not depend on it.
  std::ranges::sort(stats_.dropped_samples, {}, [](const DroppedSample& dropped) {
    return std::tuple(dropped.y, dropped.x, dropped.sample);
  });
}

double Picture::progress() const {
  return static_cast<double>(tiles_done_) / static_cast<double>(tiles_.size());
}

std::optional<double> Picture::error() const {
  std::vector<ErrorSums> sums(tiles_.size());
  workers_.for_each(tiles_.size(), [&](std::size_t i) { sums[i] = sum_errors(film_, tiles_[i]); });
  ErrorSums all;  // in the order of the tiles: the same on any number of workers
  for (const ErrorSums& tile : sums) all += tile;
  const std::optional<Wide> error = relative_error(all);
  return error ? std::optional(to_host(*error)) : std::nullopt;
}

void Picture::develop(const View& view, Exposure exposure, DevelopedPicture& developed) const {
  developed.width = film_.width();
  developed.height = film_.height();
  developed.rgb.resize(static_cast<std::size_t>(film_.width()) * static_cast<std::size_t>(film_.height()) *
                       3);
  workers_.for_each(tiles_.size(), [&](std::size_t i) {
    view.develop(*renderer_, film_, tiles_[i], exposure, developed.rgb.data());
  });
}

}  // namespace vitrine
