#include "scene_loader.h"

#include <atomic>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "firmware/fake_scene.h"

namespace vitrine {
namespace {

LoadOutcome wait_for_outcome(SceneLoader& loader) {
  while (true) {
    if (auto outcome = loader.take()) return *outcome;
    std::this_thread::yield();
  }
}

TEST(SceneLoader, OnlyTheLatestRequestCounts) {
  FakeWorld world;
  std::atomic<bool> go{false};
  std::atomic<int> begun{0};
  SceneLoader loader(
      [&](const PlaylistScene& scene, Numbers) -> std::shared_ptr<const LoadedScene> {
        ++begun;
        while (!go) std::this_thread::yield();
        if (scene.name == "broken") throw std::runtime_error("no such thing");
        return fake_scene(world);
      },
      SceneLoader::Timing::kBackground);
  loader.request(named_scene("first"), Numbers::kFloat);
  while (begun == 0) std::this_thread::yield();
  EXPECT_FALSE(loader.take());
  loader.request(named_scene("skipped"), Numbers::kFloat);
  loader.request(named_scene("broken"), Numbers::kFloat);
  go = true;
  const LoadOutcome outcome = wait_for_outcome(loader);
  EXPECT_EQ(outcome.scene, nullptr);
  EXPECT_EQ(outcome.error, "no such thing");
  EXPECT_EQ(begun, 2);
  EXPECT_FALSE(loader.take()) << "an outcome is given once";
}

TEST(SceneLoader, KeepsTheLatestScenes) {
  FakeWorld world;
  int loads = 0;
  SceneLoader loader(
      [&](const PlaylistScene&, Numbers) {
        ++loads;
        return fake_scene(world);
      },
      SceneLoader::Timing::kAtOnce);
  const auto show = [&](const std::string& name, Numbers numbers) {
    loader.request(named_scene(name), numbers);
    EXPECT_TRUE(loader.take().has_value());
  };
  show("a", Numbers::kFloat);
  show("a", Numbers::kFixed);
  show("a", Numbers::kFloat);
  EXPECT_EQ(loads, 2);
  for (const char* name : {"b", "c", "d", "e"}) show(name, Numbers::kFloat);
  show("e", Numbers::kFloat);
  EXPECT_EQ(loads, 6);
  show("a", Numbers::kFloat);
  EXPECT_EQ(loads, 7) << "the oldest gave way";
}

TEST(SceneLoader, TriesAFailedSceneAgain) {
  int loads = 0;
  SceneLoader loader(
      [&](const PlaylistScene&, Numbers) -> std::shared_ptr<const LoadedScene> {
        ++loads;
        throw std::bad_alloc();
      },
      SceneLoader::Timing::kAtOnce);
  for (int i = 0; i < 2; ++i) {
    loader.request(named_scene("a"), Numbers::kFloat);
    EXPECT_EQ(loader.take()->error, "a.gltf: out of memory; use a smaller scene");
  }
  EXPECT_EQ(loads, 2);
}

}  // namespace
}  // namespace vitrine
