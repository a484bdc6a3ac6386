#include "box_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware/temporary_folder.h"
#include "scene/input_error.h"

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
                   "mode = 'nee'\nnumbers = 'fixed'\nthreads = 3\n"));
  EXPECT_EQ(config.display, "headless");
  EXPECT_EQ(config.buttons, "sdl,script");
  EXPECT_EQ(config.playlist, folder.path() / "list.toml");
  EXPECT_EQ(config.size, (PictureSize{320, 240}));
  EXPECT_EQ(config.mode, find_mode("nee"));
  EXPECT_EQ(config.numbers, Numbers::kFixed);
  EXPECT_EQ(config.threads, 3);
}

TEST(BoxConfig, TheInstalledOneIsGoodAndLeavesAllOpen) {
  const BoxConfig config = read_box_config(VITRINE_SOURCE_DIR "/firmware/kiosk.toml");
  EXPECT_FALSE(config.display || config.buttons || config.playlist || config.size || config.mode ||
               config.threads);
}

TEST(BoxConfig, SaysWhereItIsWrong) {
  EXPECT_THAT(refusal("dispaly = 'sdl'\n"),
              HasSubstr("line 1, column 1: unknown key 'dispaly'; did you mean 'display'?"));
  EXPECT_THAT(refusal("\nsize = '0x5'\n"), HasSubstr("line 2, column 8: this is no size"));
  EXPECT_THAT(refusal("mode = 'x'\n"), HasSubstr("this is no mode"));
  EXPECT_THAT(refusal("numbers = 'double'\n"), HasSubstr("this is no numbers"));
  EXPECT_THAT(refusal("threads = 0\n"), HasSubstr("from 1 to 1024"));
  EXPECT_THAT(refusal("threads = 1.5\n"), HasSubstr("a whole number"));
}

TEST(BoxConfig, TheCommandLineHasTheLastWord) {
  BoxConfig file;
  file.display = "sdl";
  file.threads = 2;
  BoxConfig typed;
  typed.display = "headless";
  const BoxConfig both = overlay(file, typed);
  EXPECT_EQ(both.display, "headless");
  EXPECT_EQ(both.threads, 2);
}

}  // namespace
}  // namespace vitrine
