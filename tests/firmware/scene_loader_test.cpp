#include "scene_loader.h"

#include <atomic>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "firmware/fake_scene.h"
#include "firmware/temporary_folder.h"
#include "scene/input_error.h"
#include "source_file.h"

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

TEST(SceneLoader, AnotherEnvironmentIsAnotherScene) {
  FakeWorld world;
  int loads = 0;
  SceneLoader loader(
      [&](const PlaylistScene&, Numbers) {
        ++loads;
        return fake_scene(world);
      },
      SceneLoader::Timing::kAtOnce);
  PlaylistScene scene = named_scene("a");
  for (const double nits : {1.0, 2.0, 1.0}) {
    scene.environment = EnvironmentChoice{.file = "sky.hdr", .nits = nits};
    loader.request(scene, Numbers::kFloat);
  }
  EXPECT_EQ(loads, 2);
}

constexpr const char* kDarkTriangle = R"({
  "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]
})";

// Which picture lights a scene tells itself by which missing file stops it.
TEST(LoadedSceneEnvironment, TheScenesChoiceAlwaysAndTheDefaultWhereThereIsNoLight) {
  const std::filesystem::path scenes = source_file("scenes");
  PlaylistScene lit{.name = "cornell", .file = scenes / "cornell.gltf", .title = "", .caption = ""};
  const std::size_t lights = load_scene(lit, Numbers::kFloat)->baked->light_count();
  lit.default_environment = EnvironmentChoice{.file = "missing.hdr"};
  EXPECT_NO_THROW((void)load_scene(lit, Numbers::kFloat));
  lit.environment = EnvironmentChoice{.file = scenes / "evening.hdr"};
  EXPECT_EQ(load_scene(lit, Numbers::kFixed)->baked->light_count(), lights + 1);
  lit.environment->file = "missing.hdr";
  EXPECT_THROW((void)load_scene(lit, Numbers::kFloat), InputError);

  const TemporaryFolder folder;
  PlaylistScene dark{
      .name = "dark", .file = folder.write("dark.gltf", kDarkTriangle), .title = "", .caption = ""};
  EXPECT_EQ(load_scene(dark, Numbers::kFloat)->baked->light_count(), 1U) << "the default sky";
  dark.default_environment = EnvironmentChoice{.file = scenes / "evening.hdr"};
  EXPECT_EQ(load_scene(dark, Numbers::kFloat)->baked->light_count(), 1U) << "the picture instead";
  dark.default_environment->file = "missing.hdr";
  EXPECT_THROW((void)load_scene(dark, Numbers::kFloat), InputError);
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
