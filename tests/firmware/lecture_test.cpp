#include "lecture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware/temporary_folder.h"
#include "scene/input_error.h"
#include "source_file.h"

namespace vitrine {
namespace {

using testing::HasSubstr;
using testing::Not;

class LectureTest : public testing::Test {
 protected:
  [[nodiscard]] std::vector<LectureStop> read(const std::string& text) const {
    return read_lecture(folder_.write("lecture.toml", text));
  }
  /// The message with which a lecture is refused.
  [[nodiscard]] std::string refusal(const std::string& text) const {
    try {
      (void)read(text);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr((folder_.path() / "lecture.toml").string()));
      EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
      return error.what();
    }
    ADD_FAILURE() << "accepted: " << text;
    return "";
  }

  static constexpr const char* kStop = "[[stop]]\nsection = 'S'\ncaption = 'C'\nscene = 'box.gltf'\n";
  TemporaryFolder folder_;
  std::filesystem::path box_ = folder_.write("box.gltf", "{}");
  std::filesystem::path lamp_ = folder_.write("lamp.glb", "");
};

TEST_F(LectureTest, ReadsStopsInOrder) {
  const std::vector<LectureStop> stops =
      read(std::string(kStop) + "mode = 'nee'\nshadow-rays = 16\nroulette = 'constant:0.1'\n" +
           "[[stop]]\nsection = 'T'\ncaption = 'D'\nscene = 'lamp.glb'\nequal = 'time'\n" +
           "compare = 'basic, nee shadow-rays=4'\nsequence = 'sobol'\n");
  ASSERT_EQ(stops.size(), 2U);
  EXPECT_EQ(stops[0].section, "S");
  EXPECT_EQ(stops[0].caption, "C");
  EXPECT_EQ(stops[0].scene.file, box_);
  EXPECT_EQ(stops[0].techniques, std::vector{parse_technique("nee shadow-rays=16 roulette=constant:0.1")});
  EXPECT_EQ(stops[0].fairness, Fairness::kEqualSamples);
  EXPECT_EQ(stops[1].section, "T");
  EXPECT_EQ(stops[1].scene.file, lamp_);
  EXPECT_EQ(stops[1].fairness, Fairness::kEqualTime);
  EXPECT_EQ(stops[1].techniques, parse_comparison("basic sequence=sobol, nee shadow-rays=4 sequence=sobol"));
}

TEST_F(LectureTest, SaysWhereItIsWrong) {
  const std::string stop = kStop;
  EXPECT_THAT(refusal(stop + "mod = 'nee'\n"),
              HasSubstr("line 5, column 1: unknown key 'mod'; did you mean 'mode'?"));
  EXPECT_THAT(refusal(stop + "mode = 'neee'\n"),
              HasSubstr("line 5, column 8: no mode 'neee'; did you mean 'nee'?"));
  EXPECT_THAT(refusal(stop + "compare = 'nee,mix'\n"),
              HasSubstr("line 5, column 11: no mode 'mix'; did you mean 'mis'?"));
  EXPECT_THAT(refusal(stop + "compare = 'nee'\n"), HasSubstr("line 5, column 11: 'nee' is no comparison"));
  EXPECT_THAT(refusal(stop + "mode = 'nee'\nsequence = 'gird'\n"),
              HasSubstr("line 6, column 12: 'gird' is no value of sequence"));
  EXPECT_THAT(refusal(stop + "mode = 'nee'\nshadow-rays = 0\n"),
              HasSubstr("line 6, column 15: '0' is no value"));
  EXPECT_THAT(refusal(stop + "mode = 'nee'\nshadow-rays = 0.5\n"),
              HasSubstr("it must be a string or a whole number"));
  EXPECT_THAT(refusal(stop + "mode = 'basic'\nshadow-rays = 4\n"),
              HasSubstr("line 6, column 15: the mode 'basic' has no shadow-rays"));
  EXPECT_THAT(refusal(stop + "compare = 'basic,nee'\nshadow-rays = 4\n"),
              HasSubstr("the mode 'basic' has no"));
  EXPECT_THAT(refusal(stop), HasSubstr("line 1, column 1: this stop has no mode; write either"));
  EXPECT_THAT(refusal(stop + "mode = 'nee'\ncompare = 'nee,mis'\n"), HasSubstr("a mode and a comparison"));
  EXPECT_THAT(refusal(stop + "mode = 'nee'\nequal = 'rays'\n"),
              HasSubstr("line 6, column 9: 'rays' cannot be equal"));
  EXPECT_THAT(refusal("[[stop]]\ncaption = 'C'\nscene = 'box.gltf'\nmode = 'nee'\n"),
              HasSubstr("line 1, column 1: this stop has no section"));
  EXPECT_THAT(refusal("[[stop]]\nsection = 'S'\nscene = 'box.gltf'\nmode = 'nee'\n"),
              HasSubstr("has no caption"));
  EXPECT_THAT(refusal("[[stop]]\nsection = 'S'\ncaption = 'C'\nmode = 'nee'\n"), HasSubstr("has no scene"));
  EXPECT_THAT(refusal("[[stop]]\nsection = 'S'\ncaption = 'C'\nscene = 'bax.gltf'\nmode = 'nee'\n"),
              HasSubstr("line 4, column 9: no scene file 'bax.gltf'; did you mean 'box.gltf'?"));
  EXPECT_THAT(refusal("[[stop]]\nsection = 'S'\ncaption = 'C'\nscene = 'lecture.toml'\nmode = 'nee'\n"),
              HasSubstr("known are box.gltf, lamp.glb"));
  EXPECT_THAT(refusal("[[stops]]\n"), HasSubstr("did you mean 'stop'?"));
  EXPECT_THAT(refusal(""), HasSubstr("no stops; write a [[stop]] table for each"));
  EXPECT_THAT(refusal("[[stop]\n"), HasSubstr("line 1"));
}

TEST_F(LectureTest, RefusesWhatCannotBeRead) {
  EXPECT_THROW((void)read_lecture(folder_.path() / "absent.toml"), InputError);
}

TEST_F(LectureTest, TheTourGoesRoundAndComesBackToTheStopThatWasLeft) {
  LectureTour tour(read(std::string(kStop) + "mode = 'nee'\n[[stop]]\nsection = 'T'\ncaption = 'D'\n" +
                        "scene = 'box.gltf'\nmode = 'mis'\n"));
  EXPECT_FALSE(tour.empty());
  EXPECT_EQ(tour.stop(), nullptr);
  EXPECT_EQ(tour.go_on().section, "S");
  EXPECT_EQ(tour.title(), "1/2 S");
  EXPECT_EQ(tour.go_on().section, "T");
  tour.leave();
  EXPECT_EQ(tour.stop(), nullptr);
  EXPECT_EQ(tour.go_on().section, "T");
  EXPECT_EQ(tour.stop()->caption, "D");
  EXPECT_EQ(tour.go_on().section, "S");
}

// The lecture that the box is delivered with: its sections in their order, no comparison of a thing with
// itself, and captions that a small panel can show.
TEST(TheLecture, CanBeReadAndTellsItsSectionsInOrder) {
  const std::vector<LectureStop> stops = read_lecture(source_file("scenes/lecture.toml"));
  std::size_t next = 0;
  const std::vector<std::string> sections{
      "Basic path tracing",    "Russian roulette",   "Monte Carlo vs. deterministic",
      "Next event estimation", "shadow rays",        "One light",
      "Many lights",           "Indirect light",     "Importance sampling",
      "Multiple importance",   "Beyond path tracing"};
  for (const LectureStop& stop : stops) {
    if (next < sections.size() && stop.section.find(sections[next]) != std::string::npos) ++next;
    EXPECT_LT(stop.caption.size(), 160U) << stop.section;
    EXPECT_TRUE(stop.techniques.size() == 1 || stop.techniques[0] != stop.techniques[1]) << stop.section;
  }
  EXPECT_EQ(next, sections.size()) << "missing or out of order: "
                                   << sections[std::min(next, sections.size() - 1)];
}

}  // namespace
}  // namespace vitrine
