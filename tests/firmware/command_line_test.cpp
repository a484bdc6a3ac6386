#include "command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actions.h"
#include "exit_status.h"

namespace vitrine {
namespace {

using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

std::string refusal(const Words& words) {
  try {
    (void)parse_command_line(words);
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
    return error.what();
  }
  ADD_FAILURE() << "accepted " << testing::PrintToString(words);
  return "";
}

template <class T>
T parsed(const Words& words) {
  return std::get<T>(parse_command_line(words));
}

TEST(CommandLine, RunIsTheDefault) {
  EXPECT_TRUE(parsed<RunRequest>({}).scenes.empty());
  EXPECT_EQ(parsed<RunRequest>({"cornell", "a.gltf"}).scenes, (Words{"cornell", "a.gltf"}));
  const auto run = parsed<RunRequest>({"--display", "headless", "--frames", "3", "--size", "320x240", "box"});
  EXPECT_EQ(run.box.display, "headless");
  EXPECT_EQ(run.frames, 3U);
  EXPECT_EQ(run.box.size, (PictureSize{320, 240}));
  EXPECT_EQ(run.scenes, Words{"box"});
  EXPECT_EQ(run.box.mode, std::nullopt);
}

TEST(CommandLine, RenderTakesTheContractsOptions) {
  const auto render = parsed<RenderRequest>(
      {"render",    "box",   "-o",          "a.pfm", "--mode",    "nee",
       "--size",    "64x32", "--spp",       "5",     "--seed",    "18446744073709551615",
       "--threads", "3",     "--max-depth", "9",     "--numbers", "fixed",
       "--camera",  "top",   "--time",      "1.5",   "--json"});
  EXPECT_EQ(render.scene, "box");
  EXPECT_EQ(render.out, "a.pfm");
  EXPECT_EQ(render.options.mode, find_mode("nee"));
  EXPECT_EQ(render.options.width, 64);
  EXPECT_EQ(render.options.height, 32);
  EXPECT_EQ(render.spp, 5U);
  EXPECT_EQ(render.options.seed, 18446744073709551615U);
  EXPECT_EQ(render.threads, 3);
  EXPECT_EQ(render.options.max_depth, 9);
  EXPECT_EQ(render.numbers, Numbers::kFixed);
  EXPECT_EQ(render.camera, "top");
  EXPECT_EQ(render.time_s, 1.5);
  EXPECT_TRUE(render.json);
}

TEST(CommandLine, EveryParameterIsAnOptionOfRunAndRender) {
  Words words{"box", "--lecture", "tour.toml"};
  Words render_words{"render", "box", "-o", "a.png", "--mode", "mis"};
  Technique expected = technique_of(*find_mode("mis"));
  for (const Parameter& parameter : parameters()) {
    for (Words* both : {&words, &render_words}) {
      both->push_back("--" + std::string(parameter.name));
      both->emplace_back(parameter.cycle.back());
    }
    parameter.set(expected.parts, parameter.cycle.back());
  }
  const auto run = parsed<RunRequest>(words);
  EXPECT_EQ(technique_of(*find_mode("mis"), run.changes), expected);
  EXPECT_EQ(run.box.lecture, "tour.toml");
  EXPECT_EQ(parsed<RenderRequest>(render_words).techniques, std::vector{expected});
}

TEST(CommandLine, ComparesTwoModes) {
  const auto run = parsed<RunRequest>({"--compare", "basic,nee", "--equal-time"});
  EXPECT_EQ(run.compare, parse_comparison("basic,nee"));
  EXPECT_EQ(run.fairness, Fairness::kEqualTime);
  const auto render = parsed<RenderRequest>(
      {"render", "box", "-o", "a.png", "--compare", "basic,nee", "--shadow-rays", "4", "--split", "0.25"});
  EXPECT_EQ(render.techniques, parse_comparison("basic,nee shadow-rays=4")) << "for the side that has it";
  EXPECT_EQ(render.split, 0.25);
  EXPECT_EQ(render.fairness, Fairness::kEqualSamples);
}

TEST(CommandLine, RenderDefaultsToMis) {
  const auto render = parsed<RenderRequest>({"render", "box", "-o", "a.png"});
  EXPECT_EQ(render.options.mode, find_mode("mis"));
  EXPECT_EQ(render.spp, 64U);
  EXPECT_FALSE(render.replay);
}

TEST(CommandLine, ReplaysASample) {
  const auto render = parsed<RenderRequest>({"render", "box", "--pixel", "3,4", "--sample", "7"});
  ASSERT_TRUE(render.replay);
  EXPECT_EQ(render.replay->x, 3);
  EXPECT_EQ(render.replay->y, 4);
  EXPECT_EQ(render.replay->sample, 7U);
}

TEST(CommandLine, RefusesInOneLine) {
  const Words render{"render", "box", "-o", "a.pfm"};
  const auto with = [&](const Words& more) {
    Words words = render;
    words.insert(words.end(), more.begin(), more.end());
    return refusal(words);
  };
  EXPECT_THAT(with({"--mode", "mix"}), HasSubstr("no mode 'mix'; did you mean 'mis'?"));
  for (const char* size : {"0x4", "4x0", "8193x1", "4", "x", "4x", "4x4x4", "-4x4", "4 x4", ""}) {
    EXPECT_THAT(with({"--size", size}), HasSubstr("--size")) << size;
  }
  EXPECT_THAT(with({"--spp", "0"}), HasSubstr("--spp"));
  EXPECT_THAT(with({"--spp", "many"}), HasSubstr("--spp"));
  EXPECT_THAT(with({"--seed", "-1"}), HasSubstr("--seed"));
  EXPECT_THAT(with({"--threads", "0"}), HasSubstr("--threads"));
  EXPECT_THAT(with({"--max-depth", "0"}), HasSubstr("--max-depth"));
  EXPECT_THAT(with({"--numbers", "double"}), HasSubstr("float or fixed"));
  EXPECT_THAT(with({"--time", "-1"}), HasSubstr("--time"));
  EXPECT_THAT(with({"--pixel", "1"}), HasSubstr("--pixel"));
  EXPECT_THAT(with({"--pixel", "640,0"}), HasSubstr("outside the picture of 640x480"));
  EXPECT_THAT(with({"--sample", "1"}), HasSubstr("--pixel"));
  EXPECT_THAT(with({"--nonsense"}), HasSubstr("--nonsense"));
  EXPECT_THAT(with({"second"}), HasSubstr("second"));
  EXPECT_THAT(refusal({"render", "box"}), HasSubstr("-o OUT.pfm or -o OUT.png"));
  EXPECT_THAT(refusal({"render", "box", "-o", "a.jpg"}), HasSubstr("-o OUT.pfm or -o OUT.png"));
  EXPECT_THAT(refusal({"render"}), HasSubstr("SCENE"));
  EXPECT_THAT(refusal({"info"}), HasSubstr("SCENE"));
  EXPECT_THAT(refusal({"run", "--display", "sdll"}), HasSubstr("--display"));
  EXPECT_THAT(refusal({"--buttons", "script,nine"}), HasSubstr("'nine'"));
  EXPECT_THAT(refusal({"--frames", "0"}), HasSubstr("--frames"));
}

TEST(CommandLine, HelpIsComplete) {
  const std::string help = parsed<TextRequest>({"--help"}).text;
  for (const char* command : {"run", "render", "modes", "scenes", "info"})
    EXPECT_THAT(help, HasSubstr(command));
  for (const char* option : {"--display", "--script", "--spp", "--json", "Exit codes"}) {
    EXPECT_THAT(help, HasSubstr(option));
  }
  const std::string render = parsed<TextRequest>({"render", "--help"}).text;
  for (const char* option : {"--mode", "--size", "--spp", "--seed", "--threads", "--max-depth", "--numbers",
                             "--camera", "--time", "--json", "-o"}) {
    EXPECT_THAT(render, HasSubstr(option));
  }
  for (const Mode& mode : modes()) EXPECT_THAT(render, HasSubstr(std::string(mode.label)));
  const std::string run = parsed<TextRequest>({"run", "--help"}).text;
  for (const ActionButton& row : action_buttons()) EXPECT_THAT(run, HasSubstr(std::string(row.meaning)));
  EXPECT_THAT(parsed<TextRequest>({"--version"}).text, HasSubstr("vitrine 0."));
}

}  // namespace
}  // namespace vitrine
