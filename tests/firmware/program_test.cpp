// The contract of the command line: exit codes, one line on stderr, one JSON value on stdout.
#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "firmware/program_runs.h"
#include "integrators/modes.h"
#include "integrators/parameters.h"
#include "source_file.h"

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

TEST_F(ProgramTest, TheProbeTellsWhatIsHereWhateverThatIs) {
  const ProgramRun text = run_program("probe");
  EXPECT_EQ(text.status, 0) << text.err;
  for (const char* part : {"Screens\n  ", "Pins\n  ", "Input devices\n  "})
    EXPECT_THAT(text.out, HasSubstr(part));
  const ProgramRun run = run_program("probe --json");
  EXPECT_EQ(run.status, 0) << run.err;
  for (const char* key : {"cards", "framebuffers", "gpio_chips", "input_devices", "problems"})
    EXPECT_TRUE(json::parse(run.out).contains(key)) << key;
}

TEST_F(ProgramTest, WrongUsageIsTwo) {
  expect_failure("render", 2, "SCENE");
  expect_failure("render " + scene_ + " -o x.bmp", 2, "-o OUT.pfm");
  expect_failure("render " + scene_ + " -o x.png --mode nonsense", 2, "nonsense");
  expect_failure("render " + scene_ + " -o " + path("x.png") + " --camera back", 2, "front");
  expect_failure("render " + scene_ + " -o " + path("x.png") + " --camera 1", 2, "front");
  expect_failure("render " + scene_ + " -o x.png --compare basic", 2, "basic,nee");
  expect_failure("render " + scene_ + " -o x.png --compare basic,nee --mode mis", 2, "--compare");
  expect_failure("render " + scene_ + " -o x.png --equal-time", 2, "--compare");
  expect_failure("render " + scene_ + " -o x.png --mode basic --shadow-rays 4", 2, "has no shadow-rays");
  expect_failure("render " + scene_ + " -o x.png --sequence gird", 2, "did you mean 'grid'?");
  expect_failure("render " + scene_ + " -o x.png --view varience", 2, "did you mean 'variance'?");
  expect_failure("render " + scene_ + " -o x.pfm --view variance", 2, ".png");
  expect_failure("modes --jason", 2, "--jason");
  expect_failure("run --display headless --frames 1 --out frame.gif " + scene_, 2, "PNG");
}

TEST_F(ProgramTest, BadInputIsThree) {
  expect_failure("render " + path("absent.gltf") + " -o " + path("x.pfm"), 3, "absent.gltf");
  expect_failure("info " + folder_.write("broken.gltf", "{").string(), 3, "broken.gltf");
  expect_failure("info no-such-scene", 3, "no-such-scene");
  expect_failure("scenes --playlist " + folder_.write("list.toml", "[[scene]]\nfiel = 'x'\n").string(), 3,
                 "line 2, column 1");
  expect_failure("run --display headless --frames 1 " + scene_ + " --lecture " +
                     folder_.write("lecture.toml", "[[stop]]\nsection = 3\n").string(),
                 3, "line 2, column 11");
  expect_failure("run --config " + folder_.write("kiosk.toml", "size = 3\n").string(), 3, "line 1, column 8");
  expect_failure("run --display headless --frames 1 " + scene_ + " --script " +
                     folder_.write("presses", "0.1 tap nonsense\n").string(),
                 3, "line 1");
}

// A pixel beside the triangle shows the picture behind it.
TEST_F(ProgramTest, APictureLightsTheScene) {
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
  const std::string white = folder_.write("white.hdr", header + "\x80\x80\x80\x81\x80\x80\x80\x81").string();
  const std::string corner = "render " + scene_ + " --pixel 0,0 --json --environment ";
  for (const char* numbers : {"float", "fixed"}) {
    const ProgramRun run = run_program(corner + white + " --numbers " + numbers + " --environment-nits 250");
    ASSERT_EQ(run.status, 0) << run.err;
    const json shown = json::parse(run.out)["radiance"];
    for (const json& nits : shown) EXPECT_NEAR(nits.get<double>(), 250.0, 1e-3);
  }
  const json usual = json::parse(run_program(corner + white).out)["radiance"];
  EXPECT_NEAR(usual[0].get<double>(), 1000.0, 1e-2);

  expect_failure(corner + path("gone.hdr"), 3, "gone.hdr");
  expect_failure(corner + folder_.write("short.hdr", header + "abc").string(), 3, "row 0: the file ends");
  expect_failure(corner + scene_, 3, "no Radiance picture");
  expect_failure(corner + white + " --environment-nits 0", 2, "--environment-nits");
  expect_failure(corner + white + " --environment-rotation east", 2, "--environment-rotation");
  expect_failure("render " + scene_ + " -o x.png --environment-nits 5", 2, "--environment");
  expect_failure("run --display headless --frames 1 --environment " + path("gone.hdr") + " " + scene_, 3,
                 "gone.hdr");
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
    EXPECT_EQ(list[i]["unbiased"], bias(modes()[i].parts).empty());
    EXPECT_EQ(list[i]["numbers"], (json{"float", "fixed"}));
    std::size_t known = 0;
    for (const Parameter& parameter : parameters()) known += parameter.belongs(modes()[i].parts) ? 1U : 0U;
    ASSERT_EQ(list[i]["parameters"].size(), known);
    for (const json& listed : list[i]["parameters"]) {
      const Parameter* parameter = find_parameter(listed["name"].get<std::string>());
      ASSERT_NE(parameter, nullptr) << listed;
      EXPECT_EQ(listed["value"], parameter->show(modes()[i].parts));
    }
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
  if (!std::filesystem::exists(source_file("scenes/playlist.toml")))
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
  EXPECT_EQ(keys, (std::set<std::string>{"scene", "mode", "parameters", "numbers", "width", "height", "spp",
                                         "max_depth", "error_percent", "seconds", "samples_per_s", "rays",
                                         "rays_per_s", "triangles", "lights", "peak_rss_bytes",
                                         "nonfinite_samples", "nonfinite_records"}));
  EXPECT_EQ(report["scene"], "triangle");
  EXPECT_EQ(report["mode"], "mis");
  EXPECT_EQ(report["width"], 40);
  EXPECT_EQ(report["spp"], 3);
  EXPECT_EQ(report["triangles"], 1);
  EXPECT_EQ(report["nonfinite_samples"], 0);
  EXPECT_EQ(report["parameters"]["sequence"], "random");
  EXPECT_GT(report["error_percent"], 0.0) << "the triangle's edges";
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

// The left columns are those of one render, the right ones those of the other, bit for bit.
TEST_F(ProgramTest, ComparesTwoModesInOnePicture) {
  for (const std::string numbers : {"float", "fixed"}) {
    const std::string command =
        "render " + scene_ + " --size 40x30 --spp 3 --seed 7 --numbers " + numbers + " -o ";
    const ProgramRun both =
        run_program(command + path("ab.pfm") + " --compare 'basic sequence=grid,mis' --split 0.3 --json");
    ASSERT_EQ(both.status, 0) << both.err;
    const json report = json::parse(both.out);
    EXPECT_EQ(report["equal"], "samples");
    ASSERT_EQ(report["sides"].size(), 2U);
    EXPECT_EQ(report["sides"][0]["mode"], "basic");
    EXPECT_EQ(report["sides"][0]["parameters"]["sequence"], "grid");
    EXPECT_EQ(report["sides"][1]["mode"], "mis");
    EXPECT_EQ(report["sides"][1]["parameters"]["sequence"], "random");
    for (const json& side : report["sides"]) EXPECT_EQ(side["spp"], 3);

    ASSERT_EQ(run_program(command + path("a.pfm") + " --mode basic --sequence grid").status, 0);
    ASSERT_EQ(run_program(command + path("b.pfm") + " --mode mis").status, 0);
    const std::string ab = file_content(path("ab.pfm"));
    const std::string a = file_content(path("a.pfm"));
    const std::string b = file_content(path("b.pfm"));
    ASSERT_EQ(ab.size(), a.size());
    EXPECT_NE(a, b);
    const std::size_t header = ab.size() - std::size_t{40} * 30 * 12;
    for (std::size_t i = header; i < ab.size(); ++i) {
      const std::size_t column = (i - header) / 12 % 40;
      ASSERT_EQ(ab[i], (column < 12 ? a : b)[i]) << numbers << ' ' << column;
    }
  }
}

TEST_F(ProgramTest, ComparesAtEqualTime) {
  const ProgramRun run = run_program("render " + scene_ + " --size 60x60 --spp 40 --compare basic,mis " +
                                     "--equal-time --json -o " + path("ab.png"));
  ASSERT_EQ(run.status, 0) << run.err;
  const json report = json::parse(run.out);
  EXPECT_EQ(report["equal"], "time");
  EXPECT_EQ(report["sides"][0]["spp"], 40);
  EXPECT_GE(report["sides"][1]["spp"], 1);
  EXPECT_TRUE(std::filesystem::exists(path("ab.png")));
}

TEST_F(ProgramTest, ShowsTheVarianceMap) {
  const std::string command = "render " + scene_ + " --size 40x30 --spp 3 -o ";
  ASSERT_EQ(run_program(command + path("picture.png")).status, 0);
  ASSERT_EQ(run_program(command + path("variance.png") + " --view variance").status, 0);
  EXPECT_NE(file_content(path("picture.png")), file_content(path("variance.png")));
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
