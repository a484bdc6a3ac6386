#include "exhibit.h"

#include <algorithm>
#include <bit>
#include <exception>
#include <utility>

#include "mode_choice.h"

namespace vitrine {
namespace {

using std::chrono::milliseconds;

/// A pass should take about a frame: shorter ones spend too much on developing, longer ones look slow.
constexpr milliseconds kShortPass{8};
constexpr milliseconds kLongPass{25};
constexpr std::uint32_t kMaxPassSamples = 64;

/// By then a picture has converged, and 64-bit sums are far from their end.
constexpr std::uint32_t kEnoughSamples = 1U << 20U;

/// The index `by` steps on in a cycle of `count`.
std::size_t turned(std::size_t index, int by, std::size_t count) {
  const auto n = static_cast<std::ptrdiff_t>(count);
  return static_cast<std::size_t>(((static_cast<std::ptrdiff_t>(index) + by) % n + n) % n);
}

/// Half of the way, rounded away from zero, so that the goal is reached.
int half_way(int distance) { return (distance + (distance > 0 ? 1 : -1)) / 2; }

}  // namespace

Exhibit::Exhibit(ExhibitSettings settings, Pace pace, Workers& workers, LoadScene load)
    : settings_(std::move(settings)),
      pace_(pace),
      workers_(workers),
      loader_(std::move(load),
              pace == Pace::kLive ? SceneLoader::Timing::kBackground : SceneLoader::Timing::kAtOnce),
      mode_(settings_.mode != nullptr ? settings_.mode : default_mode()) {
  turn_scene(0);
}

void Exhibit::turn_scene(int by) {
  scene_index_ = turned(scene_index_, by, settings_.scenes.size());
  // A mode that the caller insists on stays; so does one that the playlist says nothing about.
  if (settings_.mode == nullptr && scene().mode != nullptr) mode_ = scene().mode;
  first_sight_ = true;
  load();
}

void Exhibit::turn_mode(int by) {
  const auto index = static_cast<std::size_t>(mode_ - modes().data());
  mode_ = &modes()[turned(index, by, modes().size())];
  start_over();
}

void Exhibit::switch_numbers() {
  settings_.numbers = settings_.numbers == Numbers::kFloat ? Numbers::kFixed : Numbers::kFloat;
  load();
}

void Exhibit::resize(PictureSize size) {
  if (size == settings_.size) return;
  settings_.size = size;
  start_over();
}

void Exhibit::brighten(int quarter_stops) {
  exposure_.quarter_stops += quarter_stops;
  manual_ = true;
  underdeveloped_ = true;
}

void Exhibit::use_auto_exposure() {
  manual_ = false;
  exposure_ = metered_;
  underdeveloped_ = true;
}

std::optional<Exposure> Exhibit::manual_exposure() const {
  return manual_ ? std::optional(exposure_) : std::nullopt;
}

void Exhibit::load() {
  start_over();
  error_.clear();
  loading_ = true;
  loader_.request(scene(), settings_.numbers);
}

void Exhibit::start_over() {
  ++edition_;
  if (picture_) {
    picture_->abandon();
    abandoned_ = std::move(picture_);
  }
  tracing_ = false;
  pass_samples_ = 1;
  if (loaded_) error_.clear();  // another mode or size may do what the last could not
}

bool Exhibit::advance(milliseconds patience) {
  abandoned_.reset();  // here the workers are waited for: by now the caller has shown the new label
  const bool arrived = take_loaded();
  if (loading_ || !error_.empty()) return arrived;
  try {
    if (!picture_) make_picture();
    if (!tracing_ && !paused_ && picture_->samples() < kEnoughSamples) start_pass();
    if (tracing_) {
      if (pace_ == Pace::kStepped) {
        picture_->finish_pass();
      } else if (!picture_->pass_ended(patience)) {
        return arrived;
      }
      end_pass();
      // The workers go on while the caller shows what they have made.
      if (pace_ == Pace::kLive && !paused_ && picture_->samples() < kEnoughSamples) start_pass();
      return true;
    }
    if (!underdeveloped_ || outdated()) return arrived;
    develop();
    return true;
  } catch (const std::exception& failure) {
    fail(failure.what());
    return true;
  }
}

bool Exhibit::take_loaded() {
  std::optional<LoadOutcome> outcome = loader_.take();
  if (!outcome) return false;
  loading_ = false;
  loaded_ = std::move(outcome->scene);
  error_ = std::move(outcome->error);
  return true;
}

void Exhibit::make_picture() {
  RenderOptions options;
  options.mode = mode_;
  options.width = settings_.size.width;
  options.height = settings_.size.height;
  options.seed = settings_.seed;
  picture_ = std::make_unique<Picture>(loaded_->baked->make_renderer(options), workers_);
}

void Exhibit::start_pass() {
  tracing_ = true;
  picture_->start_pass(pass_samples_);
}

void Exhibit::end_pass() {
  tracing_ = false;
  // The light in a picture changes little after its first samples, so it is metered ever more rarely.
  const bool doubled = std::bit_width(samples()) != std::bit_width(samples() - pass_samples_);
  if (doubled) metered_ = picture_->meter();
  if (!manual_) {
    const int distance = metered_.quarter_stops - exposure_.quarter_stops;
    exposure_.quarter_stops += first_sight_ ? distance : half_way(distance);
  }
  first_sight_ = false;
  if (pace_ == Pace::kLive) {
    if (picture_->pass_time() < kShortPass) pass_samples_ = std::min(pass_samples_ * 2, kMaxPassSamples);
    if (picture_->pass_time() > kLongPass) pass_samples_ = std::max(pass_samples_ / 2, 1U);
  }
  develop();
}

void Exhibit::develop() {
  picture_->develop(exposure_, developed_);
  underdeveloped_ = false;
}

void Exhibit::fail(const std::string& reason) {
  start_over();
  error_ = reason;
}

}  // namespace vitrine
