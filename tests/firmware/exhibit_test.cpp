#include "exhibit.h"

#include <gtest/gtest.h>

#include "firmware/fake_scene.h"
#include "integrators/film_hash.h"
#include "scene/made_scene.h"

namespace vitrine {
namespace {

const Side& left(const Exhibit& exhibit) { return *exhibit.sides().front(); }
const Side& right(const Exhibit& exhibit) { return *exhibit.sides().back(); }

class ExhibitTest : public testing::Test {
 protected:
  [[nodiscard]] static ExhibitSettings settings() {
    PlaylistScene second = named_scene("second");
    second.mode = find_mode("nee");
    ExhibitSettings settings;
    settings.scenes = {named_scene("first"), second, named_scene("third")};
    settings.size = {70, 40};
    return settings;
  }

  FakeWorld world_;
  Workers workers_{2};
};

TEST_F(ExhibitTest, EachStepAddsASample) {
  Exhibit exhibit(settings(), Pace::kStepped, workers_, fake_loader(world_));
  EXPECT_TRUE(left(exhibit).outdated());
  for (std::uint32_t n = 1; n <= 3; ++n) {
    EXPECT_TRUE(exhibit.advance({}));
    EXPECT_EQ(left(exhibit).samples(), n);
    EXPECT_FALSE(left(exhibit).outdated());
  }
  EXPECT_EQ(left(exhibit).shown.width, 70);
  EXPECT_EQ(left(exhibit).shown.rgb,
            std::vector<std::uint8_t>(70 * 40 * 3, fake_grey(*left(exhibit).technique.mode)));
}

TEST_F(ExhibitTest, TurnsBothWaysRoundTheScenesAndModes) {
  Exhibit exhibit(settings(), Pace::kStepped, workers_, fake_loader(world_));
  for (const char* name : {"third", "second", "first"}) {
    exhibit.turn_scene(-1);
    EXPECT_EQ(exhibit.scene().name, name);
  }
  for (std::size_t i = 0; i < 3; ++i) exhibit.turn_scene(1);
  EXPECT_EQ(exhibit.scene().name, "first");
  const Mode* before = left(exhibit).technique.mode;
  exhibit.turn_mode(-1);
  EXPECT_NE(left(exhibit).technique.mode, before);
  for (std::size_t i = 0; i < modes().size() + 1; ++i) exhibit.turn_mode(1);
  EXPECT_EQ(left(exhibit).technique.mode, before);
}

TEST_F(ExhibitTest, ThePlaylistsModeYieldsToAnInsistentOne) {
  Exhibit free(settings(), Pace::kStepped, workers_, fake_loader(world_));
  free.turn_scene(1);
  EXPECT_EQ(left(free).technique.mode, find_mode("nee"));

  ExhibitSettings fixed = settings();
  fixed.mode = find_mode("mis");
  Exhibit insistent(fixed, Pace::kStepped, workers_, fake_loader(world_));
  insistent.turn_scene(1);
  EXPECT_EQ(left(insistent).technique.mode, find_mode("mis"));
}

TEST_F(ExhibitTest, EveryChangeOfThePictureBeginsItAnew) {
  Exhibit exhibit(settings(), Pace::kStepped, workers_, fake_loader(world_));
  const auto begins_anew = [&](const std::function<void()>& change) {
    exhibit.advance({});
    const std::uint64_t edition = exhibit.edition();
    change();
    EXPECT_TRUE(left(exhibit).outdated());
    EXPECT_FALSE(left(exhibit).shown.rgb.empty()) << "the old picture stays until there is a new one";
    EXPECT_NE(exhibit.edition(), edition);
    exhibit.advance({});
    EXPECT_EQ(left(exhibit).samples(), 1U);
  };
  begins_anew([&] { exhibit.turn_scene(1); });
  begins_anew([&] { exhibit.turn_mode(1); });
  begins_anew([&] { exhibit.switch_numbers(); });
  begins_anew([&] { exhibit.resize({33, 21}); });
  EXPECT_EQ(left(exhibit).shown.width, 33);
  exhibit.resize({33, 21});
  EXPECT_EQ(left(exhibit).samples(), 1U) << "the same size changes nothing";
}

TEST_F(ExhibitTest, PausesBetweenPassesAndStillTakesExposures) {
  Exhibit exhibit(settings(), Pace::kStepped, workers_, fake_loader(world_));
  exhibit.advance({});
  exhibit.set_paused(true);
  EXPECT_FALSE(exhibit.advance({}));
  EXPECT_EQ(left(exhibit).samples(), 1U);
  EXPECT_FALSE(exhibit.manual_exposure());
  exhibit.brighten(2);
  EXPECT_TRUE(exhibit.advance({})) << "developed again";
  EXPECT_EQ(exhibit.manual_exposure()->quarter_stops, 4 + 2) << "beginning with the metered one";
  exhibit.use_auto_exposure();
  EXPECT_FALSE(exhibit.manual_exposure());
  exhibit.set_paused(false);
  exhibit.advance({});
  EXPECT_EQ(left(exhibit).samples(), 2U);
}

TEST_F(ExhibitTest, AChangeEndsAnEndlessPass) {
  world_.endless = true;
  Exhibit exhibit(settings(), Pace::kLive, workers_, fake_loader(world_));
  while (world_.tracing == 0) exhibit.advance(std::chrono::milliseconds(1));
  exhibit.turn_mode(1);
  EXPECT_FALSE(exhibit.tracing());
  world_.endless = false;
  while (left(exhibit).samples() == 0) exhibit.advance(std::chrono::milliseconds(1));
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
  EXPECT_EQ(left(exhibit).samples(), 1U);
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
  EXPECT_EQ(left(exhibit).samples(), 1U);
}

TEST_F(ExhibitTest, AParameterBeginsThePictureAnewAndYieldsToTheNextMode) {
  ExhibitSettings some = settings();
  some.mode = find_mode("nee");
  Exhibit exhibit(some, Pace::kStepped, workers_, fake_loader(world_));
  exhibit.advance({});
  const Parameter& rays = *find_parameter("shadow-rays");
  exhibit.turn_parameter(rays);
  EXPECT_EQ(left(exhibit).technique.parts.shadow_rays, 4);
  EXPECT_TRUE(left(exhibit).outdated());
  exhibit.advance({});
  exhibit.turn_parameter(*find_parameter("heuristic"));
  EXPECT_FALSE(left(exhibit).outdated()) << "this mode has none";
  for (int i = 0; i < 3; ++i) exhibit.turn_parameter(rays);
  EXPECT_EQ(left(exhibit).technique, technique_of(*find_mode("nee"))) << "once round";
  exhibit.turn_parameter(rays);
  exhibit.turn_mode(1);
  EXPECT_EQ(left(exhibit).technique.parts, left(exhibit).technique.mode->parts);
}

TEST_F(ExhibitTest, ChangesOfTheCommandLineHoldForEveryModeThatHasThem) {
  ExhibitSettings some = settings();
  some.mode = find_mode("basic");
  some.changes = {parse_change("shadow-rays", "16"), parse_change("sequence", "grid")};
  Exhibit exhibit(some, Pace::kStepped, workers_, fake_loader(world_));
  for (std::size_t i = 0; i < modes().size(); ++i) {
    const SamplingParts& parts = left(exhibit).technique.parts;
    EXPECT_EQ(parts.sequence, Sequence::kGrid);
    EXPECT_EQ(parts.shadow_rays, parts.direct == DirectLight::kByChance ? 1 : 16);
    exhibit.turn_mode(1);
  }
}

TEST_F(ExhibitTest, AComparisonKeepsTheLeftSideAndLetsTheRightOneCatchUp) {
  ExhibitSettings some = settings();
  some.mode = find_mode("basic");
  Exhibit exhibit(some, Pace::kStepped, workers_, fake_loader(world_));
  for (int i = 0; i < 5; ++i) exhibit.advance({});
  exhibit.toggle_comparison();
  ASSERT_TRUE(exhibit.comparing());
  EXPECT_EQ(left(exhibit).samples(), 5U);
  EXPECT_EQ(right(exhibit).technique.mode->key, left(exhibit).technique.mode->compare_with);
  EXPECT_EQ(right(exhibit).shown.rgb, left(exhibit).shown.rgb) << "until it has something of its own";
  for (int i = 0; i < 5; ++i) exhibit.advance({});
  EXPECT_EQ(left(exhibit).samples(), 5U);
  EXPECT_EQ(right(exhibit).samples(), 5U);
  for (int i = 0; i < 4; ++i) exhibit.advance({});
  EXPECT_EQ(left(exhibit).samples(), 7U);
  EXPECT_EQ(right(exhibit).samples(), 7U);

  const Technique before = left(exhibit).technique;
  exhibit.turn_mode(1);
  exhibit.advance({});
  EXPECT_EQ(left(exhibit).technique, before) << "buttons are about the right side";
  EXPECT_EQ(left(exhibit).samples(), 7U);
  EXPECT_EQ(right(exhibit).samples(), 1U);
  exhibit.toggle_comparison();
  EXPECT_FALSE(exhibit.comparing());
  exhibit.advance({});
  EXPECT_EQ(left(exhibit).samples(), 8U);
}

TEST_F(ExhibitTest, EqualTimeGivesTheCheaperSideMoreSamples) {
  ExhibitSettings some = settings();
  some.compare = parse_comparison("basic,nee");
  some.fairness = Fairness::kEqualTime;
  Exhibit exhibit(some, Pace::kStepped, workers_, fake_loader(world_));
  for (int i = 0; i < 40; ++i) exhibit.advance({});
  // A step has no time of its own: there, rays stand for it.
  EXPECT_EQ(left(exhibit).samples(), 30U);
  EXPECT_EQ(right(exhibit).samples(), 10U);
  exhibit.toggle_fairness();
  for (int i = 0; i < 20; ++i) exhibit.advance({});
  EXPECT_EQ(left(exhibit).samples(), 30U);
  EXPECT_EQ(right(exhibit).samples(), 30U);
}

TEST_F(ExhibitTest, LiveSidesStayTogether) {
  ExhibitSettings some = settings();
  some.compare = parse_comparison("basic,nee");
  Exhibit exhibit(some, Pace::kLive, workers_, fake_loader(world_));
  std::uint32_t most = 0;
  while (left(exhibit).samples() < 500) {
    exhibit.advance(std::chrono::milliseconds(1));
    EXPECT_GE(left(exhibit).samples(), right(exhibit).samples());
    EXPECT_LE(left(exhibit).samples() - right(exhibit).samples(), 64U);
    most = std::max(most, left(exhibit).samples() - right(exhibit).samples());
  }
  EXPECT_GT(most, 1U) << "passes grow";
}

TEST_F(ExhibitTest, AChangeOfTheRightSideEndsItsEndlessPassAlone) {
  ExhibitSettings some = settings();
  some.compare = parse_comparison("basic,nee");
  Exhibit exhibit(some, Pace::kLive, workers_, fake_loader(world_));
  const auto trace_until = [&](const auto& done) {
    while (!done()) exhibit.advance(std::chrono::milliseconds(1));
  };
  trace_until([&] { return right(exhibit).samples() > 0; });
  world_.endless = true;
  trace_until([&] { return world_.tracing > 0; });
  for (int i = 0; i < 4; ++i) exhibit.turn_mode(1);
  exhibit.toggle_comparison();
  exhibit.toggle_comparison();
  world_.endless = false;
  const std::uint32_t before = left(exhibit).samples();
  EXPECT_GT(before, 0U) << "the left side was not begun anew";
  trace_until([&] { return right(exhibit).samples() > 0 && left(exhibit).samples() > before; });
}

TEST_F(ExhibitTest, ShowsAnotherSceneAndGoesOnFromThere) {
  Exhibit exhibit(settings(), Pace::kStepped, workers_, fake_loader(world_));
  exhibit.show(named_scene("second"), parse_comparison("nee,mis"), Fairness::kEqualTime);
  EXPECT_TRUE(exhibit.comparing());
  EXPECT_EQ(exhibit.fairness(), Fairness::kEqualTime);
  EXPECT_EQ(exhibit.scene().name, "second");
  exhibit.show(named_scene("unlisted"), {parse_technique("basic")}, Fairness::kEqualSamples);
  EXPECT_EQ(exhibit.scene().name, "unlisted");
  EXPECT_FALSE(exhibit.comparing());
  exhibit.advance({});
  EXPECT_EQ(left(exhibit).shown.rgb.front(), fake_grey(*find_mode("basic")));
  exhibit.turn_scene(1);
  EXPECT_EQ(exhibit.scene().name, "third");
}

TEST_F(ExhibitTest, TurnsRoundTheViews) {
  Exhibit exhibit(settings(), Pace::kStepped, workers_, fake_loader(world_));
  exhibit.advance({});
  exhibit.advance({});
  const std::vector<std::uint8_t> picture = left(exhibit).shown.rgb;
  exhibit.set_paused(true);
  exhibit.turn_view(1);
  EXPECT_TRUE(exhibit.advance({})) << "developed anew, without a new sample";
  EXPECT_EQ(exhibit.view().key, "variance");
  EXPECT_NE(left(exhibit).shown.rgb, picture);
  for (std::size_t i = 1; i < views().size(); ++i) exhibit.turn_view(1);
  exhibit.advance({});
  EXPECT_EQ(left(exhibit).shown.rgb, picture);
}

// The promise of a comparison: each side is the picture that its mode makes alone, bit for bit.
class ComparisonIn : public testing::TestWithParam<Numbers> {};

TEST_P(ComparisonIn, EachSideIsThePictureOfItsModeAlone) {
  Scene scene;
  place_room(scene, 1.0, matte({0.7F, 0.5F, 0.3F}));
  place(scene, {{-0.3, 0.9, -0.3}, {0.6, 0, 0}, {0, 0, 0.6}}, lamp(glm::vec3(1.0F)));
  scene.cameras.push_back(look_at({0.6, 0.1, 0.8}, {-0.2, -0.3, -0.4}));
  const LoadScene load = [&](const PlaylistScene&, Numbers numbers) {
    auto loaded = std::make_shared<LoadedScene>();
    loaded->baked = bake(scene, numbers);
    return loaded;
  };
  ExhibitSettings settings;
  settings.scenes = {named_scene("room")};
  settings.compare = parse_comparison("basic,nee shadow-rays=4");
  settings.numbers = GetParam();
  settings.seed = 5;
  settings.size = {40, 33};
  Workers workers(2);
  Exhibit exhibit(settings, Pace::kLive, workers, load);
  while (right(exhibit).samples() < 6) exhibit.advance(std::chrono::milliseconds(1));
  exhibit.set_paused(true);
  while (exhibit.tracing()) exhibit.advance(std::chrono::milliseconds(1));

  const auto baked = bake(scene, GetParam());
  for (const std::unique_ptr<Side>& side : exhibit.sides()) {
    RenderOptions options;
    options.mode = side->technique.mode;
    options.parts = side->technique.parts;
    options.width = settings.size.width;
    options.height = settings.size.height;
    options.seed = settings.seed;
    const auto renderer = baked->make_renderer(options);
    Film alone = renderer->make_film();
    const std::atomic<bool> never{false};
    renderer->trace({0, 0, 40, 33}, {0, side->samples()}, alone, never);
    EXPECT_EQ(film_hash(side->picture->film()), film_hash(alone)) << side->technique.mode->key;
  }
  EXPECT_NE(film_hash(left(exhibit).picture->film()), film_hash(right(exhibit).picture->film()));
}

INSTANTIATE_TEST_SUITE_P(Numbers, ComparisonIn, testing::Values(Numbers::kFloat, Numbers::kFixed),
                         [](const auto& test) { return std::string(numbers_name(test.param)); });

TEST_F(ExhibitTest, TheStandInIsOnShowInThePlaceOfABrokenScene) {
  ExhibitSettings standing = settings();
  standing.stand_in = named_scene("stand-in");
  bool all_broken = false;
  const LoadScene load = [&](const PlaylistScene& scene, Numbers) -> std::shared_ptr<const LoadedScene> {
    if (scene.name == "second" || all_broken) throw std::runtime_error(scene.name + " is broken");
    return fake_scene(world_);
  };
  Exhibit exhibit(standing, Pace::kStepped, workers_, load);
  exhibit.advance({});
  EXPECT_FALSE(exhibit.standing_in());
  exhibit.turn_scene(1);
  for (int i = 0; i < 4; ++i) exhibit.advance({});
  EXPECT_TRUE(exhibit.standing_in());
  EXPECT_EQ(exhibit.error(), "second is broken");
  EXPECT_GT(left(exhibit).samples(), 0U);
  exhibit.turn_mode(1);
  for (int i = 0; i < 2; ++i) exhibit.advance({});
  EXPECT_EQ(exhibit.error(), "second is broken") << "another technique cannot mend it";
  all_broken = true;
  exhibit.switch_numbers();
  for (int i = 0; i < 4; ++i) exhibit.advance({});
  EXPECT_FALSE(exhibit.standing_in());
  EXPECT_EQ(exhibit.error(), "second is broken");
  all_broken = false;
  exhibit.turn_scene(1);
  for (int i = 0; i < 2; ++i) exhibit.advance({});
  EXPECT_EQ(exhibit.error(), "");
}

TEST_F(ExhibitTest, WithEnoughSamplesItRests) {
  ExhibitSettings few = settings();
  few.max_spp = 3;
  few.compare = parse_comparison("basic,nee");
  Exhibit exhibit(few, Pace::kStepped, workers_, fake_loader(world_));
  for (int i = 0; i < 5; ++i) exhibit.advance({});
  EXPECT_FALSE(exhibit.done() && right(exhibit).samples() < 3U);
  for (int i = 0; i < 3; ++i) exhibit.advance({});
  EXPECT_TRUE(exhibit.done());
  EXPECT_EQ(left(exhibit).samples(), 3U);
  EXPECT_EQ(right(exhibit).samples(), 3U);
  few.max_spp = 4;
  exhibit.refit(few);
  EXPECT_FALSE(exhibit.done());
  exhibit.advance({});
  EXPECT_EQ(left(exhibit).samples(), 4U) << "more samples begin nothing anew";
}

TEST_F(ExhibitTest, GoesBackToHowItBegan) {
  Exhibit exhibit(settings(), Pace::kStepped, workers_, fake_loader(world_));
  exhibit.advance({});
  const Technique began = left(exhibit).technique;
  exhibit.turn_scene(2);
  exhibit.turn_mode(1);
  exhibit.toggle_comparison();
  exhibit.switch_numbers();
  exhibit.brighten(4);
  exhibit.set_paused(true);
  exhibit.turn_view(1);
  exhibit.begin();
  EXPECT_EQ(exhibit.scene().name, "first");
  EXPECT_EQ(exhibit.sides().size(), 1U);
  EXPECT_EQ(left(exhibit).technique, began);
  EXPECT_EQ(exhibit.numbers(), Numbers::kFloat);
  EXPECT_EQ(exhibit.manual_exposure(), std::nullopt);
  EXPECT_FALSE(exhibit.paused());
  EXPECT_EQ(&exhibit.view(), &views().front());
}

}  // namespace
}  // namespace vitrine
