// The contract of the command line: exit codes, one line on stderr, one JSON value on stdout.
#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "firmware/program_runs.h"
#include "integrators/modes.h"

namespace vitrine {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A triangle that glows, and nothing else.
constexpr const char* kTriangle = R"({
  "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
  "nodes": [{"mesh": 0}, {"camera": 0, "name": "front", "translation": [0.3, 0.3, 2]}],
  "cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
  "materials": [{"emissiveFactor": [1, 0.5, 0.25], "doubleSided": true}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]
})";

class ProgramTest : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
  std::string scene_ = folder_.write("triangle.gltf", kTriangle).string();
};

void expect_failure(const std::string& arguments, int status, const std::string& message) {
  const ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.status, status) << arguments << '\n' << run.err;
  EXPECT_THAT(run.err, HasSubstr(message)) << arguments;
  EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
  EXPECT_EQ(run.out, "") << arguments;
}

TEST_F(ProgramTest, WrongUsageIsTwo) {
  expect_failure("render", 2, "SCENE");
  expect_failure("render " + scene_ + " -o x.bmp", 2, "-o OUT.pfm");
  expect_failure("render " + scene_ + " -o x.png --mode nonsense", 2, "nonsense");
  expect_failure("render " + scene_ + " -o " + path("x.png") + " --camera back", 2, "front");
  expect_failure("render " + scene_ + " -o " + path("x.png") + " --camera 1", 2, "front");
  expect_failure("modes --jason", 2, "--jason");
  expect_failure("run --display headless --frames 1 --out frame.gif " + scene_, 2, "PNG");
}

TEST_F(ProgramTest, BadInputIsThree) {
  expect_failure("render " + path("absent.gltf") + " -o " + path("x.pfm"), 3, "absent.gltf");
  expect_failure("info " + folder_.write("broken.gltf", "{").string(), 3, "broken.gltf");
  expect_failure("info no-such-scene", 3, "no-such-scene");
  expect_failure("scenes --playlist " + folder_.write("list.toml", "[[scene]]\nfiel = 'x'\n").string(), 3,
                 "line 2, column 1");
  expect_failure("run --config " + folder_.write("kiosk.toml", "size = 3\n").string(), 3, "line 1, column 8");
  expect_failure("run --display headless --frames 1 " + scene_ + " --script " +
                     folder_.write("presses", "0.1 tap nonsense\n").string(),
                 3, "line 1");
}

TEST_F(ProgramTest, RunTimeFailureIsOne) {
  expect_failure("render " + scene_ + " -o " + path("absent/x.pfm"), 1, "absent/x.pfm");
  const ProgramRun full = run_program("modes --json 1>/dev/full #");
  EXPECT_EQ(full.status, 1);
}

TEST_F(ProgramTest, ModesTellsTheTable) {
  const ProgramRun run = run_program("modes --json");
  EXPECT_EQ(run.status, 0);
  const json list = json::parse(run.out);
  ASSERT_EQ(list.size(), modes().size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(list[i]["key"], std::string(modes()[i].key));
    EXPECT_EQ(list[i]["label"], std::string(modes()[i].label));
    EXPECT_EQ(list[i]["section"], std::string(modes()[i].section));
    EXPECT_EQ(list[i]["unbiased"], modes()[i].unbiased);
    EXPECT_EQ(list[i]["numbers"], (json{"float", "fixed"}));
  }
  EXPECT_EQ(run_program("modes").status, 0);
}

TEST_F(ProgramTest, ScenesTellsThePlaylistAsResolved) {
  const auto list = folder_.write(
      "list.toml", "[[scene]]\nfile = 'triangle.gltf'\ntitle = 'T'\n[[scene]]\nfile = 'gone.glb'\n");
  const ProgramRun run = run_program("scenes --json --playlist " + list.string());
  EXPECT_EQ(run.status, 0);
  const json scenes = json::parse(run.out);
  EXPECT_EQ(scenes[0]["name"], "triangle");
  EXPECT_EQ(scenes[0]["title"], "T");
  EXPECT_EQ(scenes[0]["file"], scene_);
  EXPECT_EQ(scenes[0]["found"], true);
  EXPECT_EQ(scenes[1]["found"], false);
}

TEST_F(ProgramTest, FindsItsOwnPlaylist) {
  if (!std::filesystem::exists(VITRINE_SOURCE_DIR "/scenes/playlist.toml"))
    GTEST_SKIP() << "no scenes/playlist.toml";
  const json scenes = json::parse(run_program("scenes --json").out);
  ASSERT_FALSE(scenes.empty());
  for (const json& scene : scenes) EXPECT_EQ(scene["found"], true) << scene;
}

TEST_F(ProgramTest, InfoTellsWhatWasLoaded) {
  const ProgramRun run = run_program("info --json " + scene_);
  ASSERT_EQ(run.status, 0) << run.err;
  const json info = json::parse(run.out);
  EXPECT_EQ(info["triangles"], 1);
  EXPECT_EQ(info["emitting_materials"], 1);
  EXPECT_EQ(info["cameras"][0]["name"], "front");
  EXPECT_TRUE(info["notes"].is_array());
  EXPECT_THAT(run_program("info " + scene_).out, HasSubstr("perspective 'front'"));
}

TEST_F(ProgramTest, RendersAndReports) {
  const ProgramRun run =
      run_program("render " + scene_ + " -o " + path("t.pfm") + " --size 40x30 --spp 3 --json");
  ASSERT_EQ(run.status, 0) << run.err;
  const json report = json::parse(run.out);
  std::set<std::string> keys;
  for (const auto& [key, value] : report.items()) keys.insert(key);
  EXPECT_EQ(keys,
            (std::set<std::string>{"scene", "mode", "numbers", "width", "height", "spp", "max_depth",
                                   "seconds", "samples_per_s", "rays", "rays_per_s", "triangles", "lights",
                                   "peak_rss_bytes", "nonfinite_samples", "nonfinite_records"}));
  EXPECT_EQ(report["scene"], "triangle");
  EXPECT_EQ(report["mode"], "mis");
  EXPECT_EQ(report["width"], 40);
  EXPECT_EQ(report["spp"], 3);
  EXPECT_EQ(report["triangles"], 1);
  EXPECT_EQ(report["nonfinite_samples"], 0);
  EXPECT_GE(report["rays"], 40 * 30 * 3);
  const std::string header = "PF\n40 30\n-1.0\n";
  const std::string pfm = file_content(path("t.pfm"));
  EXPECT_EQ(pfm.substr(0, header.size()), header);
  EXPECT_EQ(pfm.size(), header.size() + 40 * 30 * 12);
}

TEST_F(ProgramTest, ThePictureIsTheSameOnAnyNumberOfThreadsAndWithBothDrivers) {
  const std::string command = "render " + scene_ + " --size 70x50 --spp 2 --seed 3 -o ";
  ASSERT_EQ(run_program(command + path("1.pfm") + " --threads 1").status, 0);
  ASSERT_EQ(run_program(command + path("7.pfm") + " --threads 7 --wave-size 100").status, 0);
  ASSERT_EQ(run_program(command + path("p.pfm") + " --driver path --camera front").status, 0);
  EXPECT_EQ(file_content(path("1.pfm")), file_content(path("7.pfm")));
  EXPECT_EQ(file_content(path("1.pfm")), file_content(path("p.pfm")));
}

TEST_F(ProgramTest, ReplaysASample) {
  const ProgramRun run = run_program("render " + scene_ + " --size 40x40 --pixel 20,20 --sample 5 --json");
  ASSERT_EQ(run.status, 0) << run.err;
  const json replay = json::parse(run.out);
  EXPECT_EQ(replay["dropped"], false);
  EXPECT_NEAR(replay["radiance"][0].get<double>(), 1.0, 1e-3);
  EXPECT_NEAR(replay["radiance"][2].get<double>(), 0.25, 1e-3);
}

TEST_F(ProgramTest, AHeadlessTourWritesAPictureOfEveryScene) {
  std::filesystem::copy_file(scene_, path("second.gltf"));
  const std::string tour =
      "run --display headless --size 64x48 --json --out " + folder_.path().string() + " " + scene_ + " ";
  const ProgramRun run = run_program(tour + path("second.gltf"));
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(json::parse(run.out)["pictures"], (json{path("triangle.png"), path("second.png")}));
  EXPECT_TRUE(std::filesystem::exists(path("triangle.png")));

  const ProgramRun broken = run_program(tour + path("absent.gltf"));
  EXPECT_EQ(broken.status, 3);
  EXPECT_THAT(broken.err, HasSubstr("absent.gltf"));
  EXPECT_EQ(json::parse(broken.out)["pictures"], json{path("triangle.png")});
}

}  // namespace
}  // namespace vitrine
