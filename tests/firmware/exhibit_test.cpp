#include "exhibit.h"

#include <gtest/gtest.h>

#include "firmware/fake_scene.h"

namespace vitrine {
namespace {

class ExhibitTest : public testing::Test {
 protected:
  [[nodiscard]] static ExhibitSettings settings() {
    PlaylistScene second = named_scene("second");
    second.mode = find_mode("nee");
    return {.scenes = {named_scene("first"), second, named_scene("third")},
            .mode = nullptr,
            .numbers = Numbers::kFloat,
            .seed = 0,
            .size = {70, 40}};
  }

  FakeWorld world_;
  Workers workers_{2};
};

TEST_F(ExhibitTest, EachStepAddsASample) {
  Exhibit exhibit(settings(), Pace::kStepped, workers_, fake_loader(world_));
  EXPECT_TRUE(exhibit.outdated());
  for (std::uint32_t n = 1; n <= 3; ++n) {
    EXPECT_TRUE(exhibit.advance({}));
    EXPECT_EQ(exhibit.samples(), n);
    EXPECT_FALSE(exhibit.outdated());
  }
  EXPECT_EQ(exhibit.picture().width, 70);
  EXPECT_EQ(exhibit.picture().rgb, std::vector<std::uint8_t>(70 * 40 * 3, fake_grey(exhibit.mode())));
}

TEST_F(ExhibitTest, TurnsBothWaysRoundTheScenesAndModes) {
  Exhibit exhibit(settings(), Pace::kStepped, workers_, fake_loader(world_));
  for (const char* name : {"third", "second", "first"}) {
    exhibit.turn_scene(-1);
    EXPECT_EQ(exhibit.scene().name, name);
  }
  for (std::size_t i = 0; i < 3; ++i) exhibit.turn_scene(1);
  EXPECT_EQ(exhibit.scene().name, "first");
  const Mode* before = &exhibit.mode();
  exhibit.turn_mode(-1);
  EXPECT_NE(&exhibit.mode(), before);
  for (std::size_t i = 0; i < modes().size() + 1; ++i) exhibit.turn_mode(1);
  EXPECT_EQ(&exhibit.mode(), before);
}

TEST_F(ExhibitTest, ThePlaylistsModeYieldsToAnInsistentOne) {
  Exhibit free(settings(), Pace::kStepped, workers_, fake_loader(world_));
  free.turn_scene(1);
  EXPECT_EQ(&free.mode(), find_mode("nee"));

  ExhibitSettings fixed = settings();
  fixed.mode = find_mode("mis");
  Exhibit insistent(fixed, Pace::kStepped, workers_, fake_loader(world_));
  insistent.turn_scene(1);
  EXPECT_EQ(&insistent.mode(), find_mode("mis"));
}

TEST_F(ExhibitTest, EveryChangeOfThePictureBeginsItAnew) {
  Exhibit exhibit(settings(), Pace::kStepped, workers_, fake_loader(world_));
  const auto begins_anew = [&](const std::function<void()>& change) {
    exhibit.advance({});
    const std::uint64_t edition = exhibit.edition();
    change();
    EXPECT_TRUE(exhibit.outdated());
    EXPECT_FALSE(exhibit.picture().rgb.empty()) << "the old picture stays until there is a new one";
    EXPECT_NE(exhibit.edition(), edition);
    exhibit.advance({});
    EXPECT_EQ(exhibit.samples(), 1U);
  };
  begins_anew([&] { exhibit.turn_scene(1); });
  begins_anew([&] { exhibit.turn_mode(1); });
  begins_anew([&] { exhibit.switch_numbers(); });
  begins_anew([&] { exhibit.resize({33, 21}); });
  EXPECT_EQ(exhibit.picture().width, 33);
  exhibit.resize({33, 21});
  EXPECT_EQ(exhibit.samples(), 1U) << "the same size changes nothing";
}

TEST_F(ExhibitTest, PausesBetweenPassesAndStillTakesExposures) {
  Exhibit exhibit(settings(), Pace::kStepped, workers_, fake_loader(world_));
  exhibit.advance({});
  exhibit.set_paused(true);
  EXPECT_FALSE(exhibit.advance({}));
  EXPECT_EQ(exhibit.samples(), 1U);
  EXPECT_FALSE(exhibit.manual_exposure());
  exhibit.brighten(2);
  EXPECT_TRUE(exhibit.advance({})) << "developed again";
  EXPECT_EQ(exhibit.manual_exposure()->quarter_stops, 4 + 2) << "beginning with the metered one";
  exhibit.use_auto_exposure();
  EXPECT_FALSE(exhibit.manual_exposure());
  exhibit.set_paused(false);
  exhibit.advance({});
  EXPECT_EQ(exhibit.samples(), 2U);
}

TEST_F(ExhibitTest, AChangeEndsAnEndlessPass) {
  world_.endless = true;
  Exhibit exhibit(settings(), Pace::kLive, workers_, fake_loader(world_));
  while (world_.tracing == 0) exhibit.advance(std::chrono::milliseconds(1));
  exhibit.turn_mode(1);
  EXPECT_FALSE(exhibit.tracing());
  world_.endless = false;
  while (exhibit.samples() == 0) exhibit.advance(std::chrono::milliseconds(1));
  EXPECT_GT(world_.cancelled, 0);
}

TEST_F(ExhibitTest, ABrokenSceneIsAnErrorUntilTheNextOne) {
  Exhibit exhibit(settings(), Pace::kStepped, workers_,
                  [this](const PlaylistScene& scene, Numbers) -> std::shared_ptr<const LoadedScene> {
                    if (scene.name == "second") throw std::runtime_error("second.gltf: broken; mend it");
                    return fake_scene(world_);
                  });
  exhibit.advance({});
  exhibit.turn_scene(1);
  EXPECT_TRUE(exhibit.advance({}));
  EXPECT_EQ(exhibit.error(), "second.gltf: broken; mend it");
  exhibit.turn_mode(1);
  EXPECT_FALSE(exhibit.advance({}));
  EXPECT_FALSE(exhibit.error().empty()) << "another mode does not mend it";
  exhibit.turn_scene(1);
  EXPECT_TRUE(exhibit.advance({}));
  EXPECT_TRUE(exhibit.error().empty());
  EXPECT_EQ(exhibit.samples(), 1U);
}

TEST_F(ExhibitTest, ABrokenRendererIsAnErrorUntilTheNextMode) {
  world_.broken = true;
  Exhibit exhibit(settings(), Pace::kStepped, workers_, fake_loader(world_));
  EXPECT_TRUE(exhibit.advance({}));
  EXPECT_EQ(exhibit.error(), "the renderer broke");
  EXPECT_FALSE(exhibit.advance({}));
  world_.broken = false;
  exhibit.turn_mode(1);
  EXPECT_TRUE(exhibit.advance({}));
  EXPECT_EQ(exhibit.samples(), 1U);
}

}  // namespace
}  // namespace vitrine
