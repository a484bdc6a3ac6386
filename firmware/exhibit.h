// What is on show: a scene of the playlist in a mode and a number system, and the picture of it that gets
// better pass by pass. Knows nothing of displays and buttons; it must only never let its caller wait.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "picture.h"
#include "picture_size.h"
#include "playlist.h"
#include "scene_loader.h"

namespace vitrine {

/// What the exhibit begins with.
struct ExhibitSettings {
  std::vector<PlaylistScene> scenes;  ///< at least one
  const Mode* mode = nullptr;         ///< nullptr: the playlist's, or default_mode()
  Numbers numbers = Numbers::kFloat;
  std::uint64_t seed = 0;
  PictureSize size;
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
  // something new.
  void turn_scene(int by);
  void turn_mode(int by);
  void switch_numbers();
  void resize(PictureSize size);
  void set_paused(bool paused) { paused_ = paused; }
  /// Sets the exposure by hand, beginning with the one in use.
  void brighten(int quarter_stops);
  void use_auto_exposure();

  /// Goes on: takes what was loaded, begins and ends passes. Live, it waits at most `patience` for the end of
  /// a pass; stepped, it does one whole pass. Returns whether picture() or error() changed.
  bool advance(std::chrono::milliseconds patience);
  /// Whether advance() has a pass to wait for.
  [[nodiscard]] bool tracing() const { return tracing_; }

  [[nodiscard]] const PlaylistScene& scene() const { return settings_.scenes[scene_index_]; }
  [[nodiscard]] const Mode& mode() const { return *mode_; }
  [[nodiscard]] Numbers numbers() const { return settings_.numbers; }
  /// Changes whenever the picture begins anew.
  [[nodiscard]] std::uint64_t edition() const { return edition_; }
  [[nodiscard]] bool paused() const { return paused_; }
  [[nodiscard]] bool loading() const { return loading_; }
  /// Set by hand, relative to none at all.
  [[nodiscard]] std::optional<Exposure> manual_exposure() const;
  /// Samples a pixel of the picture in the making.
  [[nodiscard]] std::uint32_t samples() const { return picture_ ? picture_->samples() : 0; }
  /// The latest picture; empty before the first.
  [[nodiscard]] const DevelopedPicture& picture() const { return developed_; }
  /// Whether picture() is of what was on show before.
  [[nodiscard]] bool outdated() const { return samples() == 0; }
  /// Why the scene cannot be shown; empty when it can.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  void load();
  void start_over();
  bool take_loaded();
  void make_picture();
  void start_pass();
  void end_pass();
  void develop();
  void fail(const std::string& reason);

  ExhibitSettings settings_;
  const Pace pace_;
  Workers& workers_;
  SceneLoader loader_;

  std::size_t scene_index_ = 0;
  const Mode* mode_ = nullptr;
  std::uint64_t edition_ = 0;
  bool paused_ = false;
  bool loading_ = false;
  std::string error_;
  std::shared_ptr<const LoadedScene> loaded_;  ///< of the pictures below; while loading, the one before
  std::unique_ptr<Picture> picture_;
  std::unique_ptr<Picture> abandoned_;  ///< its workers may need a moment to notice
  DevelopedPicture developed_;

  bool tracing_ = false;
  std::uint32_t pass_samples_ = 1;

  Exposure exposure_;            ///< in use
  Exposure metered_;             ///< what the automatic exposure is heading for
  bool manual_ = false;          ///< exposure_ was set by hand
  bool first_sight_ = true;      ///< of this scene: the exposure need not change smoothly
  bool underdeveloped_ = false;  ///< the exposure changed after the picture was developed
};

}  // namespace vitrine
