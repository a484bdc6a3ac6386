// Bounces played to a debouncer, by a simulated contact and a loop that looks often, seldom or once: each
// press and release is told once, also when edges are lost or told from the wrong side.
#include "debounce.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kQuiet{10};
constexpr Clock::time_point at(int ms) { return Clock::time_point{milliseconds{ms}}; }

struct LevelChange {
  bool level;
  int ms;
};
struct Told {
  bool active;
  int ms;
  bool operator==(const Told&) const = default;
};
void PrintTo(const Told& told, std::ostream* out) {
  *out << (told.active ? "press " : "release ") << told.ms;
}

/// A contact and the edges that the kernel noted of it.
struct Recording {
  std::vector<LevelChange> truth;
  std::vector<LevelChange> edges;

  [[nodiscard]] bool level(int ms) const {
    bool now = false;
    for (const LevelChange& change : truth) {
      if (change.ms <= ms) now = change.level;
    }
    return now;
  }
};

/// As GpioButtons does it, by a loop that looks every `period` ms until `end`.
std::vector<Told> watch(const Recording& recording, int period, int end, milliseconds quiet = kQuiet) {
  Debouncer debouncer(quiet);
  std::vector<Told> told;
  const auto tell = [&](std::optional<Debouncer::Change> change) {
    if (change)
      told.push_back({change->active, static_cast<int>(change->time.time_since_epoch() / milliseconds{1})});
  };
  std::size_t next = 0;
  for (int now = 0; now <= end; now += period) {
    for (; next < recording.edges.size() && recording.edges[next].ms <= now; ++next)
      tell(debouncer.edge(recording.edges[next].level, at(recording.edges[next].ms)));
    if (debouncer.deadline() && *debouncer.deadline() <= at(now))
      tell(debouncer.settle(recording.level(now)));
  }
  return told;
}

Recording clean(std::vector<LevelChange> changes) { return {changes, changes}; }

TEST(Debouncer, ABouncingPressAndReleaseAreOneEach) {
  const Recording recording = clean({{true, 100},
                                     {false, 101},
                                     {true, 103},
                                     {false, 104},
                                     {true, 106},
                                     {false, 300},
                                     {true, 302},
                                     {false, 303}});
  EXPECT_EQ(watch(recording, 1, 400), (std::vector<Told>{{true, 100}, {false, 300}}));
}

TEST(Debouncer, WaitsForQuiet) {
  Debouncer debouncer(kQuiet);
  EXPECT_FALSE(debouncer.deadline());
  EXPECT_FALSE(debouncer.edge(true, at(100)));
  EXPECT_EQ(debouncer.deadline(), at(110));
  EXPECT_FALSE(debouncer.edge(false, at(105)));
  EXPECT_EQ(debouncer.deadline(), at(115)) << "each edge begins the wait again";
}

TEST(Debouncer, ANoiseShorterThanTheQuietTimeIsNothing) {
  EXPECT_TRUE(watch(clean({{true, 100}, {false, 103}}), 1, 200).empty());
  EXPECT_EQ(watch(clean({{true, 100}, {false, 150}, {true, 155}, {false, 200}}), 1, 300),
            (std::vector<Told>{{true, 100}, {false, 200}}))
      << "a gap that short is no release";
}

TEST(Debouncer, TheReleaseIsFoundThoughItsEdgeIsLost) {
  Recording recording = clean({{true, 100}, {false, 200}, {true, 201}, {false, 202}});
  recording.edges.pop_back();
  EXPECT_EQ(watch(recording, 1, 300), (std::vector<Told>{{true, 100}, {false, 200}}));
}

TEST(Debouncer, EdgesToldFromTheWrongSideDoNoHarm) {
  Recording recording = clean({{true, 100}, {false, 101}, {true, 102}, {false, 200}});
  for (LevelChange& edge : recording.edges) edge.level = edge.ms == 101;
  EXPECT_EQ(watch(recording, 1, 300), (std::vector<Told>{{true, 100}, {false, 200}}));
}

TEST(Debouncer, ALoopThatLooksLateSeesEveryPress) {
  const Recording recording =
      clean({{true, 100}, {false, 101}, {true, 102}, {false, 200}, {true, 300}, {false, 400}});
  EXPECT_EQ(watch(recording, 5000, 5000),
            (std::vector<Told>{{true, 100}, {false, 200}, {true, 300}, {false, 400}}));
}

TEST(Debouncer, WhatIsHeldAtTheStartIsNoPress) {
  Recording stuck = clean({{true, -5}, {false, 100}, {true, 200}, {false, 300}});
  stuck.edges.erase(stuck.edges.begin());
  EXPECT_EQ(watch(stuck, 1, 400), (std::vector<Told>{{true, 200}, {false, 300}}));
}

TEST(Debouncer, WithoutAQuietTimeEachEdgeCounts) {
  EXPECT_EQ(watch(clean({{true, 100}, {false, 101}, {true, 101}, {false, 102}}), 1000, 1000, milliseconds{0}),
            (std::vector<Told>{{true, 100}, {false, 101}, {true, 101}, {false, 102}}));
  Recording lost = clean({{true, 100}, {false, 101}});
  lost.edges.pop_back();
  lost.edges.push_back({true, 101});
  EXPECT_TRUE(watch(lost, 1000, 1000, milliseconds{0}).empty() ||
              !watch(lost, 1000, 1000, milliseconds{0}).back().active);
}

TEST(Debouncer, RandomContactsAreToldPressByPress) {
  std::mt19937 random(1);
  const auto pick = [&](int from, int to) { return std::uniform_int_distribution(from, to)(random); };
  for (int round = 0; round < 2000; ++round) {
    Recording recording;
    std::vector<Told> expected;
    bool level = false;
    int now = pick(10, 50);
    for (int i = 2 * pick(1, 6); i > 0; --i) {  // as many releases as presses
      expected.push_back({!level, now});
      bool lost = false;
      for (int bounces = 2 * pick(0, 4) + 1; bounces > 0; --bounces) {
        level = !level;
        recording.truth.push_back({level, now});
        // The first edge and the last are seen well; of those between, one alone may be lost or misread.
        const bool sound = bounces == 1 || now == expected.back().ms;
        lost = !sound && !lost && pick(0, 3) == 0;
        if (!lost) recording.edges.push_back({sound || pick(0, 3) > 0 ? level : !level, now});
        if (bounces > 1) now += pick(1, 4);
      }
      now += pick(11, 200);
    }
    for (const int period : {1, 3, 7}) {
      EXPECT_EQ(watch(recording, period, now + 100), expected)
          << "round " << round << ", every " << period << " ms";
    }
    EXPECT_EQ(watch(recording, now + 100, now + 100), expected) << "round " << round << ", once";
    if (HasFailure()) return;
  }
}

}  // namespace

}  // namespace vitrine
