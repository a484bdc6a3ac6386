#include "exhibit.h"

#include <algorithm>
#include <bit>
#include <exception>
#include <limits>
#include <utility>

#include "mode_choice.h"

namespace vitrine {
namespace {

using std::chrono::milliseconds;

/// A pass should take about a frame: shorter ones spend too much on developing, longer ones look slow.
constexpr milliseconds kShortPass{8};
constexpr milliseconds kLongPass{25};
constexpr std::uint32_t kMaxPassSamples = 64;

/// Judging the error looks at every pixel: not more often than people can read, nor when little was added.
constexpr milliseconds kJudgePeriod{400};
constexpr std::uint32_t kJudgeGrowth = 8;  // an eighth more samples

/// The index `by` steps on in a cycle of `count`.
std::size_t turned(std::size_t index, int by, std::size_t count) {
  const auto n = static_cast<std::ptrdiff_t>(count);
  return static_cast<std::size_t>(((static_cast<std::ptrdiff_t>(index) + by) % n + n) % n);
}

/// Half of the way, rounded away from zero, so that the goal is reached.
int half_way(int distance) { return (distance + (distance > 0 ? 1 : -1)) / 2; }

}  // namespace

Exhibit::Exhibit(ExhibitSettings settings, Pace pace, Workers& workers, LoadScene load)
    : begun_with_(std::move(settings)),
      settings_(begun_with_),
      pace_(pace),
      workers_(workers),
      loader_(std::move(load),
              pace == Pace::kLive ? SceneLoader::Timing::kBackground : SceneLoader::Timing::kAtOnce) {
  begin();
}

void Exhibit::begin() {
  const PictureSize size = settings_.size;
  settings_ = begun_with_;
  settings_.size = size;
  std::vector<Technique> techniques = settings_.compare;
  if (techniques.empty()) {
    const Mode& mode = settings_.mode != nullptr ? *settings_.mode : *default_mode();
    techniques.push_back(technique_of(mode, settings_.changes));
  }
  set_techniques(std::move(techniques));
  paused_ = false;
  manual_ = false;
  view_index_ = 0;
  scene_index_ = 0;
  turn_scene(0);
}

void Exhibit::refit(ExhibitSettings settings) {
  const bool same_show = settings.scenes == begun_with_.scenes && settings.mode == begun_with_.mode &&
                         settings.numbers == begun_with_.numbers;
  begun_with_ = std::move(settings);
  if (same_show) {
    settings_.max_spp = begun_with_.max_spp;
  } else {
    begin();
  }
}

void Exhibit::turn_scene(int by) {
  scene_index_ = turned(scene_index_, by, settings_.scenes.size());
  scene_ = settings_.scenes[scene_index_];
  // A mode that the caller insists on stays; so do one that the playlist says nothing about, and two.
  if (settings_.mode == nullptr && scene_.mode != nullptr && !comparing())
    changed_side().technique = technique_of(*scene_.mode, settings_.changes);
  first_sight_ = true;
  load();
}

void Exhibit::turn_mode(int by) {
  const auto index = static_cast<std::size_t>(changed_side().technique.mode - modes().data());
  change_technique(technique_of(modes()[turned(index, by, modes().size())], settings_.changes));
}

void Exhibit::turn_parameter(const Parameter& parameter) {
  const Technique& before = changed_side().technique;
  const Technique after = turned(before, parameter);
  if (after != before) change_technique(after);
}

void Exhibit::change_technique(const Technique& technique) {
  changed_side().technique = technique;
  ++edition_;
  start_over(changed_side());
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

void Exhibit::toggle_comparison() {
  ++edition_;
  if (comparing()) {
    start_over(*sides_.back());
    sides_.pop_back();
  } else {
    const Side& left = *sides_.front();
    sides_.push_back(std::make_unique<Side>(partner(left.technique), left.shown));
  }
}

void Exhibit::toggle_fairness() {
  settings_.fairness =
      settings_.fairness == Fairness::kEqualSamples ? Fairness::kEqualTime : Fairness::kEqualSamples;
}

void Exhibit::show(const PlaylistScene& scene, std::vector<Technique> techniques, Fairness fairness) {
  const auto listed = std::ranges::find(settings_.scenes, scene.file, &PlaylistScene::file);
  const bool is_listed = listed != settings_.scenes.end();
  if (is_listed) scene_index_ = static_cast<std::size_t>(listed - settings_.scenes.begin());
  first_sight_ = first_sight_ || scene.file != scene_.file;
  scene_ = is_listed ? *listed : scene;
  settings_.fairness = fairness;
  set_techniques(std::move(techniques));
  load();
}

void Exhibit::set_techniques(std::vector<Technique> techniques) {
  while (sides_.size() > techniques.size()) {
    start_over(*sides_.back());
    sides_.pop_back();
  }
  while (sides_.size() < techniques.size()) {
    sides_.push_back(std::make_unique<Side>());
    sides_.back()->shown = sides_.front()->shown;
  }
  for (std::size_t i = 0; i < sides_.size(); ++i) sides_[i]->technique = techniques[i];
}

void Exhibit::turn_view(int by) {
  view_index_ = turned(view_index_, by, views().size());
  develop_later();
}

void Exhibit::brighten(int quarter_stops) {
  exposure_.quarter_stops += quarter_stops;
  manual_ = true;
  develop_later();
}

void Exhibit::use_auto_exposure() {
  manual_ = false;
  exposure_ = metered_;
  develop_later();
}

bool Exhibit::done() const { return !tracing() && sides_[turn()]->samples() >= settings_.max_spp; }

std::size_t Exhibit::turn() const {
  return comparing() ? whose_turn(fairness(), sides_.front()->share(), sides_.back()->share()) : 0;
}

std::optional<Exposure> Exhibit::manual_exposure() const {
  return manual_ ? std::optional(exposure_) : std::nullopt;
}

void Exhibit::load() {
  start_over();
  error_.clear();
  standing_in_ = false;
  loading_ = true;
  loader_.request(scene(), settings_.numbers);
}

void Exhibit::start_over() {
  ++edition_;
  for (const std::unique_ptr<Side>& side : sides_) start_over(*side);
}

void Exhibit::start_over(Side& side) {
  if (side.picture) {
    side.picture->abandon();
    abandoned_.push_back(std::move(side.picture));
  }
  if (tracing_ == &side) tracing_ = nullptr;
  side = Side(side.technique, std::move(side.shown));
  rest_until_ = {};
  if (loaded_ && !standing_in_) error_.clear();  // another technique or size may do what the last could not
}

bool Exhibit::advance(milliseconds patience) {
  abandoned_.clear();  // here the workers are waited for: by now the caller has shown the new label
  const bool arrived = take_loaded();
  if (loading_ || (!error_.empty() && !standing_in_)) return arrived;
  try {
    for (const std::unique_ptr<Side>& side : sides_) make_picture(*side);
    if (!tracing() && !paused_) start_pass();
    if (!tracing()) return develop() || arrived;
    if (pace_ == Pace::kStepped) {
      tracing_->picture->finish_pass();
    } else if (!tracing_->picture->pass_ended(patience)) {
      return arrived;
    }
    end_pass();
    // The workers go on while the caller shows what they have made.
    if (pace_ == Pace::kLive && !paused_) start_pass();
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
  if (standing_in_) {
    standing_in_ = loaded_ != nullptr;  // and the error is that of the scene
  } else {
    error_ = std::move(outcome->error);
    if (!loaded_ && settings_.stand_in) {
      standing_in_ = true;
      loading_ = true;
      loader_.request(*settings_.stand_in, settings_.numbers);
    }
  }
  return true;
}

void Exhibit::make_picture(Side& side) {
  if (side.picture) return;
  RenderOptions options;
  options.mode = side.technique.mode;
  options.parts = side.technique.parts;
  options.width = settings_.size.width;
  options.height = settings_.size.height;
  options.seed = settings_.seed;
  side.picture = std::make_unique<Picture>(loaded_->baked->make_renderer(options), workers_);
}

void Exhibit::start_pass() {
  const std::size_t next = turn();
  Side& side = *sides_[next];
  if (side.samples() >= settings_.max_spp) return;
  if (pace_ == Pace::kLive && (duty_ <= 0.0 || Clock::now() < rest_until_)) return;
  const Side& other = comparing() ? *sides_[1 - next] : side;
  turn_samples_ = turn_length(fairness(), side.share(), side.pass_samples, other.share(), other.pass_samples);
  turn_samples_ = std::min(turn_samples_, settings_.max_spp - side.samples());
  tracing_ = &side;
  side.picture->start_pass(turn_samples_);
}

void Exhibit::end_pass() {
  Side& side = *std::exchange(tracing_, nullptr);
  const std::uint64_t rays = side.picture->stats().rays - side.rays;
  const Clock::duration time = side.picture->pass_time();
  side.rays += rays;
  rays_ += rays;
  side.spent +=
      pace_ == Pace::kLive ? std::chrono::nanoseconds(time).count() : static_cast<std::int64_t>(rays);
  if (pace_ == Pace::kLive) {
    if (time < kShortPass && turn_samples_ == side.pass_samples)
      side.pass_samples = std::min(side.pass_samples * 2, kMaxPassSamples);
    if (time > kLongPass) side.pass_samples = std::max(turn_samples_ / 2, 1U);
    if (duty_ > 0.0 && duty_ < 1.0) {
      const std::chrono::duration<double> rest = time * (1.0 / duty_ - 1.0);
      rest_until_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(rest);
    }
  }
  judge(side);
  // The light in a picture changes little after its first samples, so it is metered ever more rarely.
  if (std::bit_width(side.samples()) != std::bit_width(side.samples() - turn_samples_)) meter();
  if (!manual_) {
    const int distance = metered_.quarter_stops - exposure_.quarter_stops;
    exposure_.quarter_stops += first_sight_ ? distance : half_way(distance);
    if (distance != 0) develop_later();
  }
  first_sight_ = false;
  side.underdeveloped = true;
  develop();
}

void Exhibit::judge(Side& side) {
  const Clock::time_point now = Clock::now();
  const bool grown = side.samples() - side.judged_samples >= side.judged_samples / kJudgeGrowth;
  const bool lately = now - side.judged < kJudgePeriod;
  if (pace_ == Pace::kLive && side.judged_samples > 1 && (lately || !grown)) return;
  side.error = side.picture->error();
  side.judged = now;
  side.judged_samples = side.samples();
}

void Exhibit::meter() {
  // Both sides are exposed alike: as the one that shows best how bright the scene is.
  const auto error = [](const std::unique_ptr<Side>& side) {
    return side->outdated() ? std::numeric_limits<double>::infinity() : side->error.value_or(1e9);
  };
  metered_ = (*std::ranges::min_element(sides_, {}, error))->picture->meter();
}

bool Exhibit::develop() {
  bool any = false;
  for (const std::unique_ptr<Side>& side : sides_) {
    if (!side->underdeveloped || side->outdated()) continue;
    side->picture->develop(view(), exposure_, side->shown);
    side->underdeveloped = false;
    any = true;
  }
  return any;
}

void Exhibit::develop_later() {
  for (const std::unique_ptr<Side>& side : sides_) side->underdeveloped = true;
}

void Exhibit::fail(const std::string& reason) {
  start_over();
  // When even the stand-in fails, what counts is still why it was needed.
  if (!std::exchange(standing_in_, false)) error_ = reason;
}

}  // namespace vitrine
