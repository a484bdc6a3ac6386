#include "scene_loader.h"

#include <algorithm>
#include <exception>
#include <new>

namespace vitrine {
namespace {

/// A scene in both number systems and the one before it.
constexpr std::size_t kKeptScenes = 4;

}  // namespace

SceneLoader::SceneLoader(LoadScene load, Timing timing) : load_(std::move(load)) {
  if (timing == Timing::kBackground) thread_ = std::thread([this] { work(); });
}

SceneLoader::~SceneLoader() {
  {
    const std::lock_guard lock(mutex_);
    quitting_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void SceneLoader::request(const PlaylistScene& scene, Numbers numbers) {
  const Wish wish{scene, numbers};
  const std::lock_guard lock(mutex_);
  superseded_ = true;
  wish_.reset();
  outcome_.reset();
  if (auto kept = find_kept(wish)) {
    outcome_ = LoadOutcome{std::move(kept), ""};
  } else if (thread_.joinable()) {
    wish_ = wish;
    changed_.notify_all();
  } else {
    outcome_ = load(wish);
    keep(wish, outcome_->scene);
  }
}

std::optional<LoadOutcome> SceneLoader::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(outcome_, std::nullopt);
}

bool SceneLoader::busy() const {
  const std::lock_guard lock(mutex_);
  return busy_ || wish_;
}

LoadOutcome SceneLoader::load(const Wish& wish) const {
  try {
    return {load_(wish.scene, wish.numbers), ""};
  } catch (const std::bad_alloc&) {
    return {nullptr, wish.scene.file.string() + ": out of memory; use a smaller scene"};
  } catch (const std::exception& error) {
    return {nullptr, error.what()};
  }
}

std::shared_ptr<const LoadedScene> SceneLoader::find_kept(const Wish& wish) {
  const auto found = std::ranges::find_if(kept_, [&](const auto& kept) { return kept.first.same_as(wish); });
  if (found == kept_.end()) return nullptr;
  kept_.splice(kept_.begin(), kept_, found);
  return found->second;
}

void SceneLoader::keep(const Wish& wish, const std::shared_ptr<const LoadedScene>& scene) {
  if (!scene) return;
  kept_.emplace_front(wish, scene);
  if (kept_.size() > kKeptScenes) kept_.pop_back();
}

void SceneLoader::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return quitting_ || wish_; });
    if (quitting_) return;
    const Wish wish = *std::exchange(wish_, std::nullopt);
    superseded_ = false;
    busy_ = true;
    lock.unlock();
    LoadOutcome outcome = load(wish);
    lock.lock();
    busy_ = false;
    keep(wish, outcome.scene);
    if (!superseded_) outcome_ = std::move(outcome);
  }
}

}  // namespace vitrine
