// What the driver does with samples that went wrong and with a request to stop.
#include "integrators/drivers.h"

#include <atomic>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "number_systems.h"
#include "scene/bake.h"
#include "scene/made_scene.h"
#include "statistics/picture.h"

namespace vitrine {
namespace {

/// Every path asks for one ray to find 1/4 by, a number of times; one sample finds what the test says.
template <class N>
struct Stub {
  using Radiance = typename N::Radiance;

  int stages = 1;
  std::uint32_t odd_one_bits = 0;  ///< the first random number of the sample that finds `odd`
  Vec3<Radiance> odd{};
  std::atomic<bool>* cancel = nullptr;  ///< set by the `cancel_after`th call of advance()
  int cancel_after = 0;
  mutable int calls = 0;

  static std::size_t max_branches() { return 1; }

  template <Asks<N> A>
  void begin(const Camera<N>& camera, std::uint32_t x, std::uint32_t y, const Sampler& sampler,
             std::uint32_t slot, A& asks) const {
    Path<N> path{};
    path.sampler = sampler;
    path.slot = slot;
    Sampler copy = sampler;
    asks.found(path, copy.next_bits() == odd_one_bits ? odd : Vec3<Radiance>(Radiance(0.25)));
    asks.go_on(path, camera.ray(x, y, typename N::Unit(0.5), typename N::Unit(0.5)));
  }
  template <Asks<N> A>
  void advance(Path<N> path, const Ray<N>& ray, const Hit<N>& /*hit*/, A& asks) const {
    if (++calls == cancel_after) cancel->store(true);
    if (++path.depth < static_cast<std::uint32_t>(stages)) asks.go_on(path, ray);
  }
};

template <class N>
class Drivers : public testing::Test {
 protected:
  static constexpr int kSize = 4;
  static constexpr Tile kAll{0, 0, kSize, kSize};
  static constexpr std::uint64_t kSeed = 5;

  TraceStats run(const Stub<N>& stub, const Tile& tile, SampleRange samples, std::size_t wave_size) {
    return drive<N>(stub, world_, camera_, Sequence::kRandom, kSeed, tile, samples, wave_size, film_,
                    cancel_);
  }
  int samples_on_film() const {
    std::uint32_t sum = 0;
    for (int i = 0; i < kSize * kSize; ++i) sum += film_.at(i % kSize, i / kSize).samples;
    return static_cast<int>(sum);
  }

  static Scene scene() {
    Scene scene;
    place(scene, {{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, matte(glm::vec3(0.5F)));
    scene.cameras.push_back(look_at({0, 0, 2}, {0, 0, 0}));
    return scene;
  }
  World<N> world_ = bake_world<N>(scene());
  Camera<N> camera_ = bake_camera(scene().cameras.front(), world_, kSize, kSize);
  Film film_{kSize, kSize, 0};
  std::atomic<bool> cancel_{false};
};
TYPED_TEST_SUITE(Drivers, NumberSystems, NumberSystemNames);

/// What no film takes: not finite, or beyond its range.
std::vector<Vec3<float>> refused(FloatNumbers /*numbers*/) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  return {{kNan, 1, 1}, {1, kInfinity, 1}, {1, 1, 2e6F}, {1, -1e-3F, 1}};
}
std::vector<Vec3<Wide>> refused(FixedNumbers /*numbers*/) {
  return {
      {Wide::huge(), Wide(1), Wide(1)}, {Wide(1), Wide(1) / Wide(0), Wide(1)}, {Wide(1), Wide(1), Wide(2e6)}};
}

TYPED_TEST(Drivers, DropTheSampleThatIsNotFinite) {
  const DroppedSample bad{2, 1, 3, this->kSeed};
  for (const auto& odd : refused(TypeParam{})) {
    this->film_ = Film(this->kSize, this->kSize, 0);
    Stub<TypeParam> stub;
    stub.odd_one_bits = Sampler(Sequence::kRandom, bad.seed, 2, 1, bad.sample).next_bits();
    stub.odd = odd;
    const TraceStats stats = this->run(stub, this->kAll, {0, 8}, 50);
    EXPECT_EQ(stats.samples, 8U * 16U);
    EXPECT_EQ(stats.dropped, 1U);
    EXPECT_EQ(stats.dropped_samples, std::vector<DroppedSample>{bad});
    for (int y = 0; y < this->kSize; ++y) {
      for (int x = 0; x < this->kSize; ++x) {
        const bool lost_one = x == bad.x && y == bad.y;
        EXPECT_EQ(this->film_.at(x, y).samples, lost_one ? 7U : 8U);
        EXPECT_EQ(this->film_.mean_nits(x, y), glm::dvec3(0.25));
      }
    }
    // Made again alone, from its record.
    const TraceStats again = this->run(stub, {bad.x, bad.y, bad.x + 1, bad.y + 1}, {bad.sample, 1}, 1);
    EXPECT_EQ(again.dropped_samples, std::vector<DroppedSample>{bad});
  }
}

TYPED_TEST(Drivers, KeepTheBrightestSampleThatFits) {
  Stub<TypeParam> stub;
  stub.odd_one_bits = Sampler(Sequence::kRandom, this->kSeed, 2, 1, 0).next_bits();
  using Radiance = typename TypeParam::Radiance;
  stub.odd = Vec3<Radiance>(Radiance(1e6), Radiance(1), Radiance(0x1p-36));
  EXPECT_EQ(this->run(stub, this->kAll, {0, 1}, 50).dropped, 0U);
  EXPECT_EQ(this->film_.mean_nits(2, 1), glm::dvec3(1e6, 1.0, 0x1p-36));
}

TYPED_TEST(Drivers, CountEveryDropButRecordTheFirst) {
  Film film(40, 40, 0);
  const Camera<TypeParam> camera = bake_camera(this->scene().cameras.front(), this->world_, 40, 40);
  TraceStats stats;
  for (int i = 0; i < 100; ++i) {
    Stub<TypeParam> stub;
    stub.odd_one_bits = Sampler(Sequence::kRandom, this->kSeed, static_cast<std::uint32_t>(i % 40),
                                static_cast<std::uint32_t>(i / 40), 0)
                            .next_bits();
    stub.odd = refused(TypeParam{}).front();
    stats += drive<TypeParam>(stub, this->world_, camera, Sequence::kRandom, this->kSeed,
                              {i % 40, i / 40, i % 40 + 1, i / 40 + 1}, {0, 1}, 1, film, this->cancel_);
  }
  EXPECT_EQ(stats.dropped, 100U);
  ASSERT_EQ(stats.dropped_samples.size(), TraceStats::kMaxDroppedRecords);
  EXPECT_EQ(stats.dropped_samples.back(), (DroppedSample{63 % 40, 63 / 40, 0, this->kSeed}));
}

TYPED_TEST(Drivers, StopBeforeTheFirstStageWhenCancelled) {
  this->cancel_ = true;
  const Stub<TypeParam> stub;
  const TraceStats stats = this->run(stub, this->kAll, {0, 8}, 16);
  EXPECT_TRUE(stats.cancelled);
  EXPECT_EQ(stats.samples, 0U);
  EXPECT_EQ(stub.calls, 0);
  EXPECT_EQ(this->samples_on_film(), 0);
}

TYPED_TEST(Drivers, StopWithinAStageAndLoseTheWaveUnderWay) {
  Stub<TypeParam> stub;
  stub.stages = 5;
  stub.cancel = &this->cancel_;
  stub.cancel_after = 16 * 5 * 2 + 16 + 3;  // in the second stage of the third wave
  const TraceStats stats = this->run(stub, this->kAll, {0, 8}, 16);
  EXPECT_TRUE(stats.cancelled);
  EXPECT_EQ(stub.calls, 16 * 5 * 2 + 16 * 2) << "went on beyond the stage";
  EXPECT_EQ(stats.samples, 32U);
  EXPECT_EQ(this->samples_on_film(), 32);
  EXPECT_EQ(stats.rays, static_cast<std::uint64_t>(stub.calls));
}

// A real one: next to a point light a surface is brighter than a film can hold.
TEST(DroppedSamples, AreMadeAgainByTheRenderer) {
  for (const Numbers numbers : {Numbers::kFloat, Numbers::kFixed}) {
    Scene scene;
    place(scene, {{-2, 0, -2}, {0, 0, 4}, {4, 0, 0}}, matte(glm::vec3(0.5F)));
    scene.lights.push_back(point_light(glm::vec3(1.0F), {0.0, 1e-6, 0.0}));
    scene.cameras.push_back(close_up({0.0, 1.0, 0.0}, glm::dvec3(0.0), 5e-5));
    const auto baked = bake(scene, numbers);
    const auto renderer =
        baked->make_renderer({.mode = find_mode("nee"), .width = 5, .height = 5, .seed = 9, .max_depth = 1});
    const std::atomic<bool> cancel{false};
    Film film = renderer->make_film();
    const TraceStats stats = renderer->trace({0, 0, 5, 5}, {0, 16}, film, cancel);
    ASSERT_GT(stats.dropped, 0U);
    ASSERT_LT(stats.dropped, stats.samples);
    std::uint64_t kept = 0;
    for (int i = 0; i < 25; ++i) kept += film.at(i % 5, i / 5).samples;
    EXPECT_EQ(kept + stats.dropped, stats.samples);
    for (const DroppedSample& d : stats.dropped_samples) {
      EXPECT_EQ(d.seed, 9U);
      const TraceStats again = renderer->trace({d.x, d.y, d.x + 1, d.y + 1}, {d.sample, 1}, film, cancel);
      EXPECT_EQ(again.dropped_samples, std::vector<DroppedSample>{d});
    }
  }
}

}  // namespace
}  // namespace vitrine
