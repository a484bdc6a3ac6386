// Scripted presses: what a script says, when its events are due, and how each mistake is told.
#include "script_buttons.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using std::chrono::milliseconds;

const std::vector<ButtonSpec> kBox = {
    {"scene", "Scene", "S"}, {"scene", "", "Right"}, {"mode", "Mode", "M"}, {"quit", "", "Escape"}};

Clock::time_point at(milliseconds since_start) { return Clock::time_point{since_start}; }

std::string error_of(std::string_view text) {
  try {
    parse_script(text, "demo.txt", kBox);
  } catch (const ScriptError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Script, GivesEdgesInOrderOfTime) {
  const auto events = parse_script(
      "# a demonstration\n"
      "\n"
      "1.25 press mode   # held\n"
      "  0.5\ttap scene\r\n"
      "1.5 tap scene\n"
      "1.530 release mode\n",
      "demo.txt", kBox);
  struct Expected {
    std::string button;
    Edge edge;
    milliseconds time;
  };
  const std::vector<Expected> expected = {{"scene", Edge::kPress, milliseconds{500}},
                                          {"scene", Edge::kRelease, milliseconds{500} + kTapLength},
                                          {"mode", Edge::kPress, milliseconds{1250}},
                                          {"scene", Edge::kPress, milliseconds{1500}},
                                          {"mode", Edge::kRelease, milliseconds{1530}},
                                          {"scene", Edge::kRelease, milliseconds{1500} + kTapLength}};
  ASSERT_EQ(events.size(), expected.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(events[i].button, expected[i].button) << i;
    EXPECT_EQ(events[i].edge, expected[i].edge) << i;
    EXPECT_EQ(events[i].time, at(expected[i].time)) << i;
  }
  EXPECT_TRUE(parse_script("# nothing\n\n", "demo.txt", kBox).empty());
}

TEST(Script, TellsEachMistakeWithItsLineAndRemedy) {
  EXPECT_EQ(error_of("0 tap scene\n1 tap sceen"),
            "demo.txt: line 2: no button is named 'sceen'; did you mean 'scene'?");
  EXPECT_EQ(error_of("1 tap volume"),
            "demo.txt: line 1: no button is named 'volume'; known are scene, mode, quit");
  EXPECT_EQ(error_of("1 push scene"), "demo.txt: line 1: 'push' is no event; use press, release or tap");
  EXPECT_EQ(error_of("#\n#\n1 tap"),
            "demo.txt: line 3: 2 words instead of three; write SECONDS press|release|tap NAME");
  EXPECT_EQ(error_of("1 tap scene mode"),
            "demo.txt: line 1: 4 words instead of three; write SECONDS press|release|tap NAME");
  EXPECT_EQ(error_of("1 press scene\n2 press scene"),
            "demo.txt: line 2: 'scene' is pressed while it is held; release it first");
  EXPECT_EQ(error_of("1 tap scene\n1.01 tap scene"),
            "demo.txt: line 2: 'scene' is pressed while it is held; release it first");
  EXPECT_EQ(error_of("1 press mode\n2 release scene"),
            "demo.txt: line 2: 'scene' is released but not held; press it first, or use tap");
  for (const std::string time : {"-1", "1s", "nan", "inf", "1e99", "1,5", "0x10", "+1"}) {
    EXPECT_EQ(error_of(time + " tap scene"),
              "demo.txt: line 1: '" + time +
                  "' is no time; give the seconds since the start as a decimal number from 0 to 1e7");
  }
}

TEST(Script, IsReadFromAFile) {
  std::string path = testing::TempDir() + "vitrine_script_XXXXXX";
  ASSERT_NE(mkdtemp(path.data()), nullptr);
  const std::filesystem::path file = std::filesystem::path(path) / "presses.txt";
  std::ofstream(file) << "1 tap scene\n";
  EXPECT_EQ(read_script(file, kBox).size(), 2U);
  std::ofstream(file) << "";
  EXPECT_TRUE(read_script(file, kBox).empty());
  std::ofstream(file) << "1 tap nothing\n";
  try {
    static_cast<void>(read_script(file, kBox));
    ADD_FAILURE() << "an unknown name was accepted";
  } catch (const ScriptError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(file.string() + ": line 1: ", 0), 0U) << error.what();
  }
  EXPECT_THROW(static_cast<void>(read_script(file.string() + ".missing", kBox)), ScriptError);
  EXPECT_THROW(static_cast<void>(read_script(path, kBox)), ScriptError) << "a folder";
  std::filesystem::remove_all(path);
}

TEST(ScriptButtons, GivesWhatIsDueAndNothingTwice) {
  SyntheticClock clock;
  ScriptButtons buttons(clock, parse_script("0 tap mode\n0.5 tap scene\n", "demo.txt", kBox));
  auto events = buttons.poll(milliseconds{0});
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].button, "mode");
  EXPECT_EQ(events[0].edge, Edge::kPress);
  EXPECT_TRUE(buttons.poll(milliseconds{1000}).empty()) << "the clock stands still";
  clock.advance(kTapLength - Clock::duration{1});
  EXPECT_TRUE(buttons.poll(milliseconds{0}).empty());
  clock.advance(Clock::duration{1});
  EXPECT_EQ(buttons.poll(milliseconds{0}).size(), 1U);
  clock.advance(std::chrono::seconds{10});
  events = buttons.poll(milliseconds{0});
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].time, at(milliseconds{500})) << "an event keeps its own time";
  EXPECT_TRUE(buttons.poll(milliseconds{0}).empty());
}

TEST(Clocks, OneStandsStillAndTheOtherGoes) {
  SyntheticClock synthetic;
  EXPECT_EQ(synthetic.now(), Clock::time_point{});
  synthetic.advance(milliseconds{16});
  synthetic.advance(milliseconds{17});
  EXPECT_EQ(synthetic.now(), at(milliseconds{33}));

  const SystemClock system;
  const Clock::time_point before = Clock::now();
  const Clock::time_point now = system.now();
  EXPECT_LE(before, now);
  EXPECT_LE(now, Clock::now());
}

}  // namespace
}  // namespace vitrine
