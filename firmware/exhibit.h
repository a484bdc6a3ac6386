// What is on show: a scene of the playlist in a number system, and one way of sampling it or two side by
// side, whose pictures get better pass by pass. Knows nothing of displays and buttons; it must only never let
// its caller wait.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comparison.h"
#include "picture.h"
#include "picture_size.h"
#include "playlist.h"
#include "scene_loader.h"
#include "side.h"

namespace vitrine {

/// By then a picture has converged, and 64-bit sums are far from their end.
inline constexpr std::uint32_t kEnoughSamples = 1U << 20U;

/// What the exhibit begins with.
struct ExhibitSettings {
  std::vector<PlaylistScene> scenes;     ///< at least one
  const Mode* mode = nullptr;            ///< nullptr: the playlist's, or default_mode()
  std::vector<ParameterChange> changes;  ///< to every mode that has such parameters
  std::vector<Technique> compare;        ///< two to begin with side by side, or none
  Fairness fairness = Fairness::kEqualSamples;
  Numbers numbers = Numbers::kFloat;
  std::uint64_t seed = 0;
  PictureSize size;
  std::uint32_t max_spp = kEnoughSamples;   ///< with which a picture is done and tracing rests
  std::optional<PlaylistScene> stand_in{};  ///< on show in the place of a scene that cannot be loaded
};

/// How the exhibit gets on.
enum class Pace : std::uint8_t {
  kLive,     ///< as fast as the machine is, never waiting long
  kStepped,  ///< one sample a pixel each step, everything waited for: the same pictures on every machine
};

class Exhibit {
 public:
  Exhibit(ExhibitSettings settings, Pace pace, Workers& workers, LoadScene load);

  // Changes answer at once: they end the pass under way, and what is shown stays until advance() has
  // something new. Those of the technique are about the right one of two sides: the left one is what it is
  // compared with, and goes on.
  void turn_scene(int by);
  void turn_mode(int by);
  void turn_parameter(const Parameter& parameter);
  void switch_numbers();
  void resize(PictureSize size);
  /// Puts the partner of the technique on show beside it, or takes the right side away.
  void toggle_comparison();
  void toggle_fairness();
  /// Shows another scene, of the playlist or not, by one technique or two. The next turn of the scene goes on
  /// from where the playlist has it.
  void show(const PlaylistScene& scene, std::vector<Technique> techniques, Fairness fairness);
  void set_paused(bool paused) { paused_ = paused; }
  void turn_view(int by);
  /// Sets the exposure by hand, beginning with the one in use.
  void brighten(int quarter_stops);
  void use_auto_exposure();
  /// Back to how it began.
  void begin();
  /// Takes other settings, but for the size. Begins anew unless they leave alone what is on show.
  void refit(ExhibitSettings settings);

  /// The part of its time that it may trace, 0 to 1. Live only.
  void set_duty(double duty) { duty_ = duty; }

  /// Goes on: takes what was loaded, begins and ends passes. Live, it waits at most `patience` for the end of
  /// a pass; stepped, it does one whole pass, of one side. Returns whether sides() or error() changed.
  bool advance(std::chrono::milliseconds patience);
  /// Whether advance() has a pass to wait for.
  [[nodiscard]] bool tracing() const { return tracing_ != nullptr; }

  [[nodiscard]] const PlaylistScene& scene() const { return scene_; }
  /// One, or the left and the right one of a comparison.
  [[nodiscard]] std::span<const std::unique_ptr<Side>> sides() const { return sides_; }
  [[nodiscard]] bool comparing() const { return sides_.size() == 2; }
  [[nodiscard]] Fairness fairness() const { return settings_.fairness; }
  [[nodiscard]] const View& view() const { return views()[view_index_]; }
  [[nodiscard]] Numbers numbers() const { return settings_.numbers; }
  /// Changes whenever a picture begins anew.
  [[nodiscard]] std::uint64_t edition() const { return edition_; }
  [[nodiscard]] bool paused() const { return paused_; }
  [[nodiscard]] bool loading() const { return loading_; }
  /// Whether its end would have to wait for a load that nobody can stop.
  [[nodiscard]] bool held_by_a_load() const { return loader_.busy(); }
  /// Set by hand, relative to none at all.
  [[nodiscard]] std::optional<Exposure> manual_exposure() const;
  /// Traced by the passes that ended, of all pictures since the beginning.
  [[nodiscard]] std::uint64_t rays() const { return rays_; }
  /// Why the scene cannot be shown; empty when it can.
  [[nodiscard]] const std::string& error() const { return error_; }
  /// Whether sides() show the stand-in because of that error.
  [[nodiscard]] bool standing_in() const { return standing_in_; }
  /// Whether the pictures have all the samples that they get.
  [[nodiscard]] bool done() const;

 private:
  void load();
  void set_techniques(std::vector<Technique> techniques);
  /// The side that the changes of the technique are about.
  Side& changed_side() { return *sides_.back(); }
  void change_technique(const Technique& technique);
  void start_over();
  void start_over(Side& side);
  bool take_loaded();
  void make_picture(Side& side);
  /// The index of the side that goes on.
  [[nodiscard]] std::size_t turn() const;
  void start_pass();
  void end_pass();
  void judge(Side& side);
  void meter();
  /// Develops what has become outdated; returns whether anything had.
  bool develop();
  void develop_later();
  void fail(const std::string& reason);

  ExhibitSettings begun_with_;
  ExhibitSettings settings_;  ///< the same, and what was changed since
  const Pace pace_;
  Workers& workers_;
  SceneLoader loader_;

  std::size_t scene_index_ = 0;  ///< in the playlist
  PlaylistScene scene_;
  std::size_t view_index_ = 0;
  std::uint64_t edition_ = 0;
  bool paused_ = false;
  bool loading_ = false;
  std::string error_;
  bool standing_in_ = false;
  double duty_ = 1.0;
  Clock::time_point rest_until_;               ///< a new picture need not wait for it
  std::shared_ptr<const LoadedScene> loaded_;  ///< of the pictures below; while loading, the one before
  std::vector<std::unique_ptr<Side>> sides_;
  Side* tracing_ = nullptr;                          ///< the side whose pass is under way
  std::uint32_t turn_samples_ = 0;                   ///< of that pass
  std::vector<std::unique_ptr<Picture>> abandoned_;  ///< their workers may need a moment to notice
  std::uint64_t rays_ = 0;

  Exposure exposure_;        ///< in use
  Exposure metered_;         ///< what the automatic exposure is heading for
  bool manual_ = false;      ///< exposure_ was set by hand
  bool first_sight_ = true;  ///< of this scene: the exposure need not change smoothly
};

}  // namespace vitrine
