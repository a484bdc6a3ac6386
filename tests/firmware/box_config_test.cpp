#include "box_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware/temporary_folder.h"
#include "scene/input_error.h"
#include "source_file.h"

namespace vitrine {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
  const TemporaryFolder folder;
  try {
    (void)read_box_config(folder.write("kiosk.toml", text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BoxConfig, ReadsEveryKey) {
  const TemporaryFolder folder;
  const BoxConfig config = read_box_config(
      folder.write("kiosk.toml",
                   "display = 'headless'\nbuttons = 'sdl,script'\nplaylist = 'list.toml'\nsize = '320x240'\n"
                   "mode = 'nee'\nnumbers = 'fixed'\nthreads = 3\nlecture = 'tour.toml'\n"
                   "environment = 'sky.hdr'\nenvironment_nits = 20\nenvironment_rotation = -1.5\n"));
  EXPECT_EQ(config.display_key(), "headless");
  EXPECT_EQ(config.buttons, "sdl,script");
  EXPECT_EQ(config.playlist, folder.path() / "list.toml");
  EXPECT_EQ(config.lecture, folder.path() / "tour.toml");
  EXPECT_EQ(config.size, (PictureSize{320, 240}));
  EXPECT_EQ(config.mode, find_mode("nee"));
  EXPECT_EQ(config.numbers, Numbers::kFixed);
  EXPECT_EQ(config.threads, 3);
  EXPECT_EQ(config.environment,
            (EnvironmentChoice{.file = folder.path() / "sky.hdr", .nits = 20.0, .rotation_deg = -1.5}));
}

TEST(BoxConfig, TheInstalledOneIsGoodAndLeavesAllOpen) {
  const BoxConfig config = read_box_config(source_file("firmware/kiosk.toml"));
  EXPECT_EQ(config.display_key(), "auto");
  EXPECT_FALSE(config.buttons || config.playlist || config.size || config.mode || config.threads ||
               config.environment);
}

TEST(BoxConfig, SaysWhereItIsWrong) {
  EXPECT_THAT(refusal("dispaly = 'sdl'\n"),
              HasSubstr("line 1, column 1: unknown key 'dispaly'; did you mean 'display'?"));
  EXPECT_THAT(refusal("\nsize = '0x5'\n"), HasSubstr("line 2, column 8: this is no size"));
  EXPECT_THAT(refusal("mode = 'x'\n"), HasSubstr("this is no mode"));
  EXPECT_THAT(refusal("numbers = 'double'\n"), HasSubstr("this is no numbers"));
  EXPECT_THAT(refusal("threads = 0\n"), HasSubstr("from 1 to 1024"));
  EXPECT_THAT(refusal("threads = 1.5\n"), HasSubstr("a whole number"));
  EXPECT_THAT(refusal("environment = 3\n"), HasSubstr("it must be a string"));
  EXPECT_THAT(refusal("environment = 'a.hdr'\nenvironment_nits = 0\n"), HasSubstr("line 2, column 20"));
  EXPECT_THAT(refusal("environment = 'a.hdr'\nenvironment_rotation = 'left'\n"), HasSubstr("line 2"));
  EXPECT_THAT(refusal("environment_nits = 10\n"), HasSubstr("without environment"));
}

TEST(BoxConfig, TheCommandLineHasTheLastWord) {
  BoxConfig file;
  file.display = "sdl";
  file.threads = 2;
  BoxConfig typed;
  typed.display = "headless";
  file.environment = EnvironmentChoice{.file = "a.hdr", .nits = 5.0};
  const BoxConfig both = overlay(file, typed);
  EXPECT_EQ(both.display, "headless");
  EXPECT_EQ(both.threads, 2);
  EXPECT_EQ(both.environment, file.environment);
  typed.environment = EnvironmentChoice{.file = "b.hdr"};
  EXPECT_EQ(overlay(file, typed).environment, typed.environment);
}

}  // namespace
}  // namespace vitrine
