#include "playlist.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware/temporary_folder.h"
#include "scene/input_error.h"

namespace vitrine {
namespace {

using testing::HasSubstr;
using testing::Not;

class PlaylistTest : public testing::Test {
 protected:
  /// The message with which a playlist of this text is refused.
  [[nodiscard]] std::string refusal(const std::string& text) const {
    const std::filesystem::path path = folder_.write("playlist.toml", text);
    try {
      (void)read_playlist(path);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(path.string()));
      EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
      return error.what();
    }
    ADD_FAILURE() << "accepted: " << text;
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(PlaylistTest, ReadsScenesInOrder) {
  const auto path = folder_.write(
      "playlist.toml",
      "[[scene]]\nfile = 'b/box.gltf'\ntitle = 'A box'\ncaption = 'See?'\nmode = 'nee'\n"
      "[[scene]]\nfile = 'lamp.glb'\nenvironment = 'sky/dusk.hdr'\nenvironment_rotation = 90\n");
  const std::vector<PlaylistScene> scenes = read_playlist(path);
  ASSERT_EQ(scenes.size(), 2U);
  EXPECT_EQ(scenes[0].name, "box");
  EXPECT_EQ(scenes[0].file, folder_.path() / "b/box.gltf");
  EXPECT_EQ(scenes[0].title, "A box");
  EXPECT_EQ(scenes[0].caption, "See?");
  EXPECT_EQ(scenes[0].mode, find_mode("nee"));
  EXPECT_EQ(scenes[1].title, "lamp");
  EXPECT_EQ(scenes[1].mode, nullptr);
  EXPECT_FALSE(scenes[0].environment);
  EXPECT_EQ(scenes[1].environment,
            (EnvironmentChoice{.file = folder_.path() / "sky/dusk.hdr", .rotation_deg = 90.0}));
}

TEST_F(PlaylistTest, SaysWhereItIsWrong) {
  EXPECT_THAT(refusal("[[scene]]\nfile = 'a.gltf'\ntitl = 'A'\n"),
              HasSubstr("line 3, column 1: unknown key 'titl'; did you mean 'title'?"));
  EXPECT_THAT(refusal("[[scene]]\nfile = 'a.gltf'\nmode = 'mix'\n"),
              HasSubstr("line 3, column 8: no mode 'mix'; did you mean 'mis'?"));
  EXPECT_THAT(refusal("[[scene]]\ntitle = 'A'\n"), HasSubstr("line 1, column 1: this scene has no file"));
  EXPECT_THAT(refusal("[[scene]]\nfile = 3\n"),
              HasSubstr("line 2, column 8: 'file' has another type; it must be a string"));
  EXPECT_THAT(refusal("[[scene]]\nfile = 'a.gltf'\n[[scene]]\nfile = 'b/a.glb'\n"),
              HasSubstr("line 3, column 1: a second scene 'a'"));
  EXPECT_THAT(refusal("[[scene]\n"), HasSubstr("line 1"));
  EXPECT_THAT(refusal("[[scenes]]\nfile = 'a.gltf'\n"), HasSubstr("did you mean 'scene'?"));
  EXPECT_THAT(refusal("scene = 'a'\n"), HasSubstr("line 1, column 9: no scenes"));
  EXPECT_THAT(refusal(""), HasSubstr("no scenes"));
}

TEST_F(PlaylistTest, RefusesWhatCannotBeRead) {
  EXPECT_THROW((void)read_playlist(folder_.path() / "absent.toml"), InputError);
  EXPECT_THROW((void)read_playlist(folder_.path()), InputError);
}

TEST_F(PlaylistTest, ResolvesFilesAndNames) {
  const auto path = folder_.write("playlist.toml", "[[scene]]\nfile = 'box.gltf'\ntitle = 'A box'\n");
  const std::vector<PlaylistScene> playlist = read_playlist(path);
  EXPECT_EQ(resolve_scene("box", playlist).title, "A box");
  EXPECT_EQ(resolve_scene("some/Lamp.GLB", playlist).name, "Lamp");
  EXPECT_EQ(resolve_scene("some/Lamp.GLB", {}).file, "some/Lamp.GLB");
  try {
    (void)resolve_scene("bax", playlist);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'box'?"));
  }
}

}  // namespace
}  // namespace vitrine
