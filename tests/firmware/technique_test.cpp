#include "technique.h"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "comparison.h"

namespace vitrine {
namespace {

using testing::HasSubstr;

/// How a text is refused: "problem; remedy".
std::string refusal(const std::function<void()>& parse) {
  try {
    parse();
  } catch (const UnknownChoice& unknown) {
    return std::string(unknown.what()) + "; " + unknown.remedy();
  }
  ADD_FAILURE() << "accepted";
  return "";
}

TEST(Technique, IsAModeWithChanges) {
  EXPECT_EQ(parse_technique("nee"), technique_of(*find_mode("nee")));
  const Technique changed = parse_technique("  nee  shadow-rays=16 roulette=constant:0.1 ");
  EXPECT_EQ(changed.mode, find_mode("nee"));
  EXPECT_EQ(changed.parts.shadow_rays, 16);
  EXPECT_EQ(changed.parts.stop.kind, StoppingRule::Kind::kConstant);
  EXPECT_EQ(changed.parts.lights, find_mode("nee")->parts.lights);
  const std::vector<Technique> two = parse_comparison("basic, nee shadow-rays=4");
  EXPECT_EQ(two[0], parse_technique("basic"));
  EXPECT_EQ(two[1], parse_technique("nee shadow-rays=4"));
}

TEST(Technique, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(refusal([] { parse_technique("neee"); }), HasSubstr("no mode 'neee'; did you mean 'nee'?"));
  EXPECT_THAT(refusal([] { parse_technique(""); }), HasSubstr("no mode ''"));
  EXPECT_THAT(refusal([] { parse_technique("nee shadow-ray=4"); }),
              HasSubstr("no parameter 'shadow-ray'; did you mean 'shadow-rays'?"));
  EXPECT_THAT(refusal([] { parse_technique("nee sequence=sobl"); }),
              HasSubstr("'sobl' is no value of sequence (random|grid|stratified|sobol|blue-noise); did you "
                        "mean 'sobol'?"));
  EXPECT_THAT(refusal([] { parse_technique("nee shadow-rays"); }), HasSubstr("says no value"));
  EXPECT_THAT(refusal([] { parse_technique("basic shadow-rays=4"); }),
              HasSubstr("the mode 'basic' has no shadow-rays; known are"));
  EXPECT_THAT(refusal([] { parse_comparison("nee"); }), HasSubstr("like basic,nee"));
  EXPECT_THAT(refusal([] { parse_comparison("nee,mis,basic"); }), HasSubstr("like basic,nee"));
  EXPECT_THAT(refusal([] { parse_comparison("nee,"); }), HasSubstr("no mode ''"));
}

TEST(Technique, EveryModeHasAPartnerOtherThanItself) {
  for (const Mode& mode : modes()) {
    ASSERT_NE(find_mode(mode.compare_with), nullptr) << mode.key;
    EXPECT_NE(mode.compare_with, mode.key);
    EXPECT_EQ(partner(technique_of(mode)), technique_of(*find_mode(mode.compare_with)));
  }
}

// Every parameter, in every mode that has it: a button press changes it, and after a whole cycle all is as it
// was.
TEST(Technique, AParameterTurnsRoundItsCycle) {
  for (const Mode& mode : modes()) {
    for (const Parameter& parameter : parameters()) {
      const Technique before = technique_of(mode);
      if (!parameter.belongs(before.parts)) {
        EXPECT_EQ(turned(before, parameter), before);
        continue;
      }
      Technique technique = before;
      for (std::size_t i = 0; i < parameter.cycle.size(); ++i) {
        const Technique next = turned(technique, parameter);
        EXPECT_NE(next.parts, technique.parts) << mode.key << ' ' << parameter.name;
        EXPECT_EQ(next.parts == before.parts, describe_changes(next).empty())
            << mode.key << ' ' << describe_changes(next);
        technique = next;
      }
      EXPECT_EQ(technique, before) << mode.key << ' ' << parameter.name;
    }
  }
}

TEST(Technique, AValueOutsideTheCycleTurnsToItsBeginning) {
  const Parameter& rays = *find_parameter("shadow-rays");
  EXPECT_EQ(turned(parse_technique("nee shadow-rays=77"), rays), parse_technique("nee shadow-rays=1"));
}

TEST(Technique, SaysWhatDiffersFromTheMode) {
  EXPECT_EQ(describe_changes(parse_technique("nee")), "");
  EXPECT_EQ(describe_changes(parse_technique("nee sequence=grid shadow-rays=16")),
            "Shadow rays 16, Sequence grid");
}

TEST(Technique, BesideItsLikeSaysWhatTellsThemApart) {
  const std::vector<Technique> two = parse_comparison("nee sequence=grid, nee sequence=random");
  EXPECT_EQ(describe_changes(two[0], &two[1]), "Sequence grid");
  EXPECT_EQ(describe_changes(two[1], &two[0]), "Sequence random");
  const Technique other = parse_technique("basic");
  EXPECT_EQ(describe_changes(two[1], &other), "");
  EXPECT_EQ(describe_changes(two[1], &two[1]), "");
}

TEST(Comparison, TheOneThatHasHadLessGoesOn) {
  const Share few{.samples = 3, .spent = 900};
  const Share many{.samples = 5, .spent = 100};
  EXPECT_EQ(whose_turn(Fairness::kEqualSamples, few, many), 0U);
  EXPECT_EQ(whose_turn(Fairness::kEqualSamples, many, few), 1U);
  EXPECT_EQ(whose_turn(Fairness::kEqualSamples, few, few), 0U);
  EXPECT_EQ(whose_turn(Fairness::kEqualTime, few, many), 1U);
  EXPECT_EQ(whose_turn(Fairness::kEqualTime, many, few), 0U);
}

TEST(Comparison, CatchesUpWithoutOvertaking) {
  const Share behind{.samples = 3};
  const Share ahead{.samples = 5};
  EXPECT_EQ(turn_length(Fairness::kEqualSamples, behind, 64, ahead, 1), 2U);
  EXPECT_EQ(turn_length(Fairness::kEqualSamples, behind, 1, ahead, 64), 1U);
  EXPECT_EQ(turn_length(Fairness::kEqualSamples, ahead, 64, ahead, 4), 4U) << "no further than the slow one";
  EXPECT_EQ(turn_length(Fairness::kEqualTime, behind, 64, ahead, 1), 64U);
}

}  // namespace
}  // namespace vitrine
