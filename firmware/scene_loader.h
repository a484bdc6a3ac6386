// Scenes are read and baked on a thread of their own, since that may take seconds in which the box must
// answer. Only the latest request matters; scenes shown before are kept, so that going back is quick.
#pragma once

#include <condition_variable>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "loaded_scene.h"

namespace vitrine {

/// What became of a request: a scene, or a line that says why there is none.
struct LoadOutcome {
  std::shared_ptr<const LoadedScene> scene;
  std::string error;
};

class SceneLoader {
 public:
  enum class Timing : std::uint8_t {
    kBackground,  ///< request() returns at once
    kAtOnce,  ///< request() returns with the scene: what a script needs to give the same frames every time
  };

  SceneLoader(LoadScene load, Timing timing);
  /// Waits for the load under way.
  ~SceneLoader();
  SceneLoader(const SceneLoader&) = delete;
  SceneLoader& operator=(const SceneLoader&) = delete;

  /// Asks for a scene instead of the one asked for before.
  void request(const PlaylistScene& scene, Numbers numbers);
  /// The outcome of the latest request, once, when it is there.
  std::optional<LoadOutcome> take();
  /// Whether a load is under way, be it one that nobody wants any more.
  [[nodiscard]] bool busy() const;

 private:
  struct Wish {
    PlaylistScene scene;
    Numbers numbers = Numbers::kFloat;

    [[nodiscard]] bool same_as(const Wish& other) const {
      return scene.file == other.scene.file && scene.environment == other.scene.environment &&
             scene.default_environment == other.scene.default_environment && numbers == other.numbers;
    }
  };

  [[nodiscard]] LoadOutcome load(const Wish& wish) const;
  [[nodiscard]] std::shared_ptr<const LoadedScene> find_kept(const Wish& wish);
  void keep(const Wish& wish, const std::shared_ptr<const LoadedScene>& scene);
  void work();

  const LoadScene load_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Wish> wish_;  ///< asked for and not begun
  bool superseded_ = false;   ///< the load under way is of no use any more
  bool busy_ = false;
  bool quitting_ = false;
  std::optional<LoadOutcome> outcome_;
  std::list<std::pair<Wish, std::shared_ptr<const LoadedScene>>> kept_;  ///< the latest first
  std::thread thread_;                                                   ///< with kBackground
};

}  // namespace vitrine
