// Gestures on injected time: what each rule does alone, how they exclude each other, and, for random hands on
// random boxes, the promises that hold whatever happens.
#include "gestures.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace vitrine {

bool operator==(const Gesture& a, const Gesture& b) {
  return a.action == b.action && a.kind == b.kind && a.time == b.time;
}
void PrintTo(const Gesture& gesture, std::ostream* out) {
  static const std::map<GestureKind, std::string> kNames = {{GestureKind::kShort, "short"},
                                                            {GestureKind::kLong, "long"},
                                                            {GestureKind::kRepeat, "repeat"},
                                                            {GestureKind::kChord, "chord"}};
  *out << kNames.at(gesture.kind) << ' ' << gesture.action << " at "
       << gesture.time.time_since_epoch() / std::chrono::milliseconds{1} << " ms";
}

namespace {

using std::chrono::milliseconds;
using Gestures = std::vector<Gesture>;

constexpr GestureKind kShort = GestureKind::kShort;
constexpr GestureKind kLong = GestureKind::kLong;
constexpr GestureKind kRepeat = GestureKind::kRepeat;
constexpr GestureKind kChord = GestureKind::kChord;

constexpr Clock::time_point at(int ms) { return Clock::time_point{milliseconds{ms}}; }
ButtonEvent down(const std::string& button, int ms) { return {button, Edge::kPress, at(ms)}; }
ButtonEvent up(const std::string& button, int ms) { return {button, Edge::kRelease, at(ms)}; }

/// A hand that is watched all the time: take() at every event and at every deadline.
Gestures play(std::vector<GestureRule> rules, const std::vector<ButtonEvent>& events, int end_ms) {
  GestureRecogniser recogniser(rules);
  Gestures all;
  const auto take = [&](std::span<const ButtonEvent> some, Clock::time_point now) {
    for (Gesture& gesture : recogniser.take(some, now)) all.push_back(std::move(gesture));
  };
  const auto wait_until = [&](Clock::time_point time) {
    while (recogniser.deadline() && *recogniser.deadline() <= time) take({}, *recogniser.deadline());
  };
  for (const ButtonEvent& event : events) {
    wait_until(event.time);
    take(std::span(&event, 1), event.time);
  }
  wait_until(at(end_ms));
  return all;
}

/// The same when nobody looks before the end.
Gestures play_at_once(std::vector<GestureRule> rules, const std::vector<ButtonEvent>& events, int end_ms) {
  return GestureRecogniser(rules).take(events, at(end_ms));
}

GestureRule rule(GestureKind kind, std::vector<std::string> buttons, std::string action, int after_ms = 0,
                 int every_ms = 0) {
  return {std::move(buttons), kind, std::move(action), milliseconds{after_ms}, milliseconds{every_ms}};
}

TEST(Gestures, AButtonWithoutARuleActsAtItsPress) {
  EXPECT_EQ(play({}, {down("a", 10), up("a", 5000)}, 9000), (Gestures{{"a", kShort, at(10)}}));
}

TEST(Gestures, AShortRuleAloneActsAtThePressToo) {
  EXPECT_EQ(play({rule(kShort, {"a"}, "go")}, {down("a", 10), up("a", 60)}, 900),
            (Gestures{{"go", kShort, at(10)}}));
}

TEST(Gestures, WithALongRuleAShortPressWaitsForTheRelease) {
  const std::vector<GestureRule> rules{rule(kLong, {"a"}, "menu", 700)};
  EXPECT_EQ(play(rules, {down("a", 10), up("a", 709)}, 9000), (Gestures{{"a", kShort, at(709)}}));
  EXPECT_EQ(play({rule(kShort, {"a"}, "go"), rules[0]}, {down("a", 10), up("a", 200)}, 9000),
            (Gestures{{"go", kShort, at(200)}}));
}

TEST(Gestures, ALongPressFiresAtItsThresholdWhileHeldAndItsReleaseIsSilent) {
  GestureRecogniser recogniser(std::vector{rule(kLong, {"a"}, "menu", 700)});
  EXPECT_FALSE(recogniser.deadline());
  EXPECT_EQ(recogniser.take(std::vector{down("a", 10)}, at(10)), Gestures{});
  EXPECT_EQ(recogniser.deadline(), at(710));
  EXPECT_EQ(recogniser.take({}, at(709)), Gestures{});
  EXPECT_EQ(recogniser.take({}, at(710)), (Gestures{{"menu", kLong, at(710)}}));
  EXPECT_FALSE(recogniser.deadline());
  EXPECT_EQ(recogniser.take(std::vector{up("a", 5000)}, at(5000)), Gestures{});
  EXPECT_EQ(recogniser.take(std::vector{down("a", 6000), up("a", 6001)}, at(6001)),
            (Gestures{{"a", kShort, at(6001)}}));
}

TEST(Gestures, AReleaseExactlyAtTheThresholdIsLong) {
  EXPECT_EQ(play({rule(kLong, {"a"}, "menu", 700)}, {down("a", 10), up("a", 710)}, 9000),
            (Gestures{{"menu", kLong, at(710)}}));
}

TEST(Gestures, ALateLookTellsLongFromShortByTheTimesOfTheEdges) {
  const std::vector<GestureRule> rules{rule(kLong, {"a"}, "menu", 700)};
  EXPECT_EQ(play_at_once(rules, {down("a", 0), up("a", 300)}, 5000), (Gestures{{"a", kShort, at(300)}}));
  EXPECT_EQ(play_at_once(rules, {down("a", 0), up("a", 900)}, 5000), (Gestures{{"menu", kLong, at(700)}}));
}

TEST(Gestures, TimesLeftOpenHaveDefaults) {
  EXPECT_EQ(play({rule(kLong, {"a"}, "menu")}, {down("a", 0)}, 9000),
            (Gestures{{"menu", kLong, Clock::time_point{kLongPress}}}));
  const Gestures repeated = play({rule(kRepeat, {"a"}, "more")}, {down("a", 0)}, 900);
  ASSERT_EQ(repeated.size(), 4U);
  EXPECT_EQ(repeated[1].time, Clock::time_point{kRepeatDelay});
  EXPECT_EQ(repeated[2].time, Clock::time_point{kRepeatDelay + kRepeatPeriod});
}

TEST(Gestures, ARepeatActsAtThePressAfterItsDelayAndEveryPeriodUntilTheRelease) {
  EXPECT_EQ(play({rule(kRepeat, {"a"}, "more", 400, 100)}, {down("a", 0), up("a", 650)}, 9000),
            (Gestures{{"more", kShort, at(0)},
                      {"more", kRepeat, at(400)},
                      {"more", kRepeat, at(500)},
                      {"more", kRepeat, at(600)}}));
}

TEST(Gestures, AShortRuleBesideARepeatSaysWhatThePressDoes) {
  EXPECT_EQ(play({rule(kRepeat, {"a"}, "more", 400, 100), rule(kShort, {"a"}, "go")},
                 {down("a", 0), up("a", 450)}, 9000),
            (Gestures{{"go", kShort, at(0)}, {"more", kRepeat, at(400)}}));
}

TEST(Gestures, AfterALongPressRepeatsFollowAPeriodLater) {
  const std::vector<GestureRule> rules{rule(kRepeat, {"a"}, "more", 100, 50),
                                       rule(kLong, {"a"}, "menu", 700)};
  EXPECT_EQ(play(rules, {down("a", 0), up("a", 820)}, 9000),
            (Gestures{{"menu", kLong, at(700)}, {"more", kRepeat, at(750)}, {"more", kRepeat, at(800)}}));
  EXPECT_EQ(play(rules, {down("a", 0), up("a", 500)}, 9000), (Gestures{{"more", kShort, at(500)}}));
}

TEST(Gestures, ALoopThatStalledGetsOneRepeatAndThePhaseStays) {
  GestureRecogniser recogniser(std::vector{rule(kRepeat, {"a"}, "more", 400, 100)});
  EXPECT_EQ(recogniser.take(std::vector{down("a", 0)}, at(0)).size(), 1U);
  EXPECT_EQ(recogniser.take({}, at(3050)), (Gestures{{"more", kRepeat, at(400)}}));
  EXPECT_EQ(recogniser.deadline(), at(3100));
}

TEST(Gestures, AChordFiresWithItsLastPressAndSilencesItsMembers) {
  const std::vector<GestureRule> rules{rule(kChord, {"a", "b"}, "both", 100), rule(kLong, {"a"}, "menu", 700),
                                       rule(kRepeat, {"b"}, "more", 300, 100)};
  EXPECT_EQ(play(rules, {down("b", 0), down("a", 99), up("b", 2000), up("a", 2500)}, 9000),
            (Gestures{{"both", kChord, at(99)}}));
}

TEST(Gestures, PressesTooFarApartAreNoChord) {
  EXPECT_EQ(play({rule(kChord, {"a", "b"}, "both", 100)},
                 {down("a", 0), down("b", 100), up("a", 300), up("b", 301)}, 9000),
            (Gestures{{"a", kShort, at(100)}, {"b", kShort, at(200)}}));
}

TEST(Gestures, AMemberAloneIsShortAtItsReleaseOrAtTheEndOfTheWindow) {
  const std::vector<GestureRule> rules{rule(kChord, {"a", "b"}, "both", 100)};
  EXPECT_EQ(play(rules, {down("a", 0), up("a", 30), down("b", 40), up("b", 400)}, 9000),
            (Gestures{{"a", kShort, at(30)}, {"b", kShort, at(140)}}));
}

TEST(Gestures, AMemberWithALongRuleWaitsOnAfterTheWindow) {
  const std::vector<GestureRule> rules{rule(kChord, {"a", "b"}, "both", 100),
                                       rule(kLong, {"a"}, "menu", 700)};
  EXPECT_EQ(play(rules, {down("a", 0), up("a", 300)}, 9000), (Gestures{{"a", kShort, at(300)}}));
  EXPECT_EQ(play(rules, {down("a", 0), up("a", 900)}, 9000), (Gestures{{"menu", kLong, at(700)}}));
  EXPECT_EQ(play(rules, {down("a", 0), down("b", 150), up("b", 160), up("a", 900)}, 9000),
            (Gestures{{"b", kShort, at(160)}, {"menu", kLong, at(700)}}));
}

TEST(Gestures, ALongPressEndsTheWaitForALooseChord) {
  const std::vector<GestureRule> rules{rule(kChord, {"a", "b"}, "both", 2000),
                                       rule(kLong, {"a"}, "menu", 700)};
  EXPECT_EQ(play(rules, {down("a", 0), down("b", 800), up("b", 900), up("a", 950)}, 9000),
            (Gestures{{"menu", kLong, at(700)}, {"b", kShort, at(900)}}));
}

TEST(Gestures, TheLargerOfTwoChordsWins) {
  const std::vector<GestureRule> rules{rule(kChord, {"a", "b"}, "two", 100),
                                       rule(kChord, {"a", "b", "c"}, "three", 150)};
  EXPECT_EQ(play(rules, {down("a", 0), down("b", 50), down("c", 149), up("a", 400)}, 9000),
            (Gestures{{"three", kChord, at(149)}}));
  EXPECT_EQ(play(rules, {down("a", 0), down("b", 50), up("a", 400), up("b", 400)}, 9000),
            (Gestures{{"two", kChord, at(150)}}))
      << "the smaller one waits for the larger";
  EXPECT_EQ(play(rules, {down("a", 0), down("b", 50), up("b", 80), down("c", 90), up("a", 200), up("c", 300)},
                 9000),
            (Gestures{{"two", kChord, at(80)}, {"c", kShort, at(240)}}))
      << "but not beyond a release";
}

TEST(Gestures, AReleaseInTheBatchOfItsPressCounts) {
  const std::vector<GestureRule> rules{rule(kLong, {"a"}, "menu", 700)};
  EXPECT_EQ(play_at_once(rules, {down("a", 5), up("a", 5), down("a", 9), up("a", 9)}, 10),
            (Gestures{{"a", kShort, at(5)}, {"a", kShort, at(9)}}));
}

TEST(Gestures, AReleaseOfTheUnknownIsNothing) {
  const std::vector<GestureRule> rules{rule(kLong, {"a"}, "menu", 700)};
  EXPECT_EQ(play(rules, {up("a", 5), up("z", 6), down("a", 7), up("a", 8), up("a", 9)}, 9000),
            (Gestures{{"a", kShort, at(8)}}));
}

TEST(Gestures, ASecondPressOfWhatIsHeldEndsTheFirst) {
  const std::vector<GestureRule> rules{rule(kLong, {"a"}, "menu", 700)};
  EXPECT_EQ(play(rules, {down("a", 0), down("a", 100), up("a", 900)}, 9000),
            (Gestures{{"a", kShort, at(100)}, {"menu", kLong, at(800)}}));
}

TEST(Gestures, TimesFromTheFutureAreTakenAsNow) {
  GestureRecogniser recogniser(std::vector{rule(kLong, {"a"}, "menu", 700)});
  EXPECT_EQ(recogniser.take(std::vector{down("a", 999'999)}, at(10)), Gestures{});
  EXPECT_EQ(recogniser.deadline(), at(710));
}

TEST(Gestures, RulesThatMakeNoSenseAreRefusedWithARemedy) {
  const auto problem = [](const std::vector<GestureRule>& rules) {
    return rule_problem(rules, rules.size() - 1);
  };
  const GestureRule good = rule(kChord, {"a", "b"}, "go", 50);
  EXPECT_EQ(problem({good}), "");
  EXPECT_EQ(problem({good, rule(kChord, {"a", "b", "c"}, "go")}), "");
  EXPECT_EQ(problem({rule(kLong, {"a"}, "go"), rule(kShort, {"a"}, "go")}), "");
  EXPECT_NE(problem({good, rule(kChord, {"b", "a"}, "no")}), "");
  EXPECT_NE(problem({rule(kLong, {"a"}, "go", 500), rule(kLong, {"a"}, "no", 900)}), "");
  EXPECT_NE(problem({rule(kChord, {"a"}, "no")}), "");
  EXPECT_NE(problem({rule(kChord, {"a", "a"}, "no")}), "");
  EXPECT_NE(problem({rule(kShort, {"a", "b"}, "no")}), "");
  EXPECT_NE(problem({rule(kShort, {}, "no")}), "");
  EXPECT_NE(problem({rule(kShort, {""}, "no")}), "");
  EXPECT_NE(problem({rule(kShort, {"a"}, "")}), "");
  EXPECT_NE(problem({rule(kShort, {"a"}, "no", 10)}), "");
  EXPECT_NE(problem({rule(kLong, {"a"}, "no", -1)}), "");
  EXPECT_NE(problem({rule(kLong, {"a"}, "no", 10, 10)}), "");
  EXPECT_NE(problem({rule(kRepeat, {"a"}, "no", 10, -10)}), "");
  EXPECT_THROW(GestureRecogniser(std::vector{rule(kChord, {"a"}, "no")}), std::invalid_argument);
}

/// A random box and a random hand on it; names are unique, so that an action tells its rule.
struct RandomSession {
  explicit RandomSession(unsigned seed) : random(seed) {
    for (const std::string& button : buttons) {
      if (chance(2)) rules.push_back(rule(kShort, {button}, "short " + button));
      if (chance(2)) rules.push_back(rule(kLong, {button}, "long " + button, pick(1, 60)));
      if (chance(2)) rules.push_back(rule(kRepeat, {button}, "repeat " + button, pick(1, 60), pick(1, 20)));
    }
    if (chance(2)) rules.push_back(rule(kChord, {"a", "b"}, "chord ab", pick(1, 40)));
    if (chance(2)) rules.push_back(rule(kChord, {"b", "c"}, "chord bc", pick(1, 40)));
    if (chance(2)) rules.push_back(rule(kChord, {"a", "b", "c"}, "chord abc", pick(1, 40)));
    if (chance(3)) rules.push_back(rule(kChord, {"a", "b", "c", "d"}, "chord abcd", pick(1, 40)));
    std::ranges::shuffle(rules, random);

    std::set<std::string> held;
    int now = 0;
    for (int i = pick(1, 60); i > 0; --i) {
      now += chance(3) ? 0 : pick(1, 30);
      const std::string& button = buttons[static_cast<std::size_t>(pick(0, 3))];
      if (held.contains(button)) {
        events.push_back(up(button, now));
        held.erase(button);
      } else {
        events.push_back(down(button, now));
        held.insert(button);
      }
    }
    for (const std::string& button : held) events.push_back(up(button, now += pick(0, 100)));
    end = now + 200;
  }

  bool chance(int one_in) { return pick(1, one_in) == 1; }
  int pick(int from, int to) { return std::uniform_int_distribution(from, to)(random); }

  std::mt19937 random;
  std::vector<std::string> buttons{"a", "b", "c", "d"};
  std::vector<GestureRule> rules;
  std::vector<ButtonEvent> events;
  int end = 0;
};

struct Hold {
  Clock::time_point from;
  Clock::time_point to;
};

std::map<std::string, std::vector<Hold>> holds_of(const std::vector<ButtonEvent>& events) {
  std::map<std::string, std::vector<Hold>> holds;
  for (const ButtonEvent& event : events) {
    if (event.edge == Edge::kPress) {
      holds[event.button].push_back({event.time, Clock::time_point::max()});
    } else {
      holds[event.button].back().to = event.time;
    }
  }
  return holds;
}

/// The buttons whose presses a gesture accounts for.
std::set<std::string> accounted(const Gesture& gesture, const std::vector<GestureRule>& rules) {
  for (const GestureRule& candidate : rules) {
    if (candidate.action == gesture.action) return {candidate.buttons.begin(), candidate.buttons.end()};
  }
  return {gesture.action};  // the action of the button's own name
}

Gestures without_repeats(Gestures gestures) {
  std::erase_if(gestures, [](const Gesture& gesture) { return gesture.kind == kRepeat; });
  return gestures;
}

TEST(Gestures, EveryPressIsExactlyOneGestureWhileItIsHeld) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomSession session(seed);
    const Gestures gestures = play(session.rules, session.events, session.end);
    EXPECT_TRUE(std::ranges::is_sorted(gestures, {}, &Gesture::time));

    // Each gesture falls to the one hold of each of its buttons that has none yet, in order.
    const auto holds = holds_of(session.events);
    std::map<std::string, std::size_t> next;
    for (const Gesture& gesture : without_repeats(gestures)) {
      for (const std::string& button : accounted(gesture, session.rules)) {
        const std::size_t n = next[button]++;
        ASSERT_LT(n, holds.at(button).size()) << testing::PrintToString(gesture);
        EXPECT_GE(gesture.time, holds.at(button)[n].from) << testing::PrintToString(gesture);
        EXPECT_LE(gesture.time, holds.at(button)[n].to) << testing::PrintToString(gesture);
      }
    }
    for (const auto& [button, list] : holds) EXPECT_EQ(next[button], list.size()) << button;
    if (HasFailure()) return;
  }
}

TEST(Gestures, RepeatsComeWhileHeldAfterAShortOrLongAndNeverSoonerThanTheirPeriod) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomSession session(seed);
    const auto holds = holds_of(session.events);
    std::map<std::string, Gesture> latest;  // by button
    for (const Gesture& gesture : play(session.rules, session.events, session.end)) {
      if (gesture.kind == kRepeat) {
        const auto found = std::ranges::find_if(session.rules, [&](const GestureRule& candidate) {
          return candidate.kind == kRepeat && candidate.action == gesture.action;
        });
        ASSERT_NE(found, session.rules.end());
        const std::string& button = found->buttons.front();
        EXPECT_TRUE(std::ranges::any_of(holds.at(button), [&](const Hold& hold) {
          return gesture.time >= hold.from + std::min(found->after, found->every) && gesture.time <= hold.to;
        })) << testing::PrintToString(gesture);
        ASSERT_TRUE(latest.contains(button));
        EXPECT_NE(latest.at(button).kind, kChord) << testing::PrintToString(gesture);
        if (latest.at(button).kind == kRepeat) {
          EXPECT_GE(gesture.time - latest.at(button).time, found->every) << testing::PrintToString(gesture);
        }
        latest.at(button) = gesture;
      } else {
        for (const std::string& button : accounted(gesture, session.rules)) {
          latest.insert_or_assign(button, gesture);
        }
      }
    }
    if (HasFailure()) return;
  }
}

TEST(Gestures, HowOftenTheLoopLooksChangesNothingButTheRepeats) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomSession session(seed);
    const Gestures watched = without_repeats(play(session.rules, session.events, session.end));
    EXPECT_EQ(without_repeats(play_at_once(session.rules, session.events, session.end)), watched);
    if (HasFailure()) return;
  }
}

TEST(Gestures, NothingHappensBeforeTheDeadline) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomSession session(seed);
    GestureRecogniser recogniser(session.rules);
    for (const ButtonEvent& event : session.events) {
      while (recogniser.deadline() && *recogniser.deadline() <= event.time) {
        const Clock::time_point deadline = *recogniser.deadline();
        EXPECT_EQ(recogniser.take({}, deadline - Clock::duration{1}), Gestures{});
        ASSERT_EQ(recogniser.deadline(), deadline);
        static_cast<void>(recogniser.take({}, deadline));
        ASSERT_NE(recogniser.deadline(), deadline) << "it passed";
      }
      static_cast<void>(recogniser.take(std::span(&event, 1), event.time));
    }
  }
}

TEST(Gestures, AtTheEndNothingIsLeftWaiting) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const RandomSession session(seed);
    GestureRecogniser recogniser(session.rules);
    static_cast<void>(recogniser.take(session.events, at(session.end)));
    EXPECT_FALSE(recogniser.deadline()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace vitrine
