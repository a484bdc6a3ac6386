// Scripted sessions of the real box: the same script shows the same frames, on any number of threads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "firmware/program_runs.h"
#include "source_file.h"

namespace vitrine {
namespace {

class SessionTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kScene)) GTEST_SKIP() << kScene << " is missing";
  }

  /// The last frame of a session, as a PNG's bytes.
  [[nodiscard]] std::string last_frame(const std::string& script, const std::string& options) const {
    const std::string out = folder_.path() / "last.png";
    const ProgramRun run =
        run_program("run --display headless --size 160x120 --script " +
                    folder_.write("script", script).string() + " --out " + out + " " + options);
    EXPECT_EQ(run.status, 0) << run.err;
    return file_content(out);
  }

  const std::string kScene = source_file("scenes/cornell.gltf");
  TemporaryFolder folder_;
};

TEST_F(SessionTest, TheSameScriptShowsTheSameFrames) {
  const std::string script =
      "0.05 tap mode\n0.1 tap exposure-up\n0.15 tap numbers\n0.3 tap pause\n0.4 tap quit\n";
  const std::string one = last_frame(script, kScene + " --threads 1");
  EXPECT_FALSE(one.empty());
  EXPECT_EQ(one, last_frame(script, kScene + " --threads 3"));
  EXPECT_NE(one, last_frame("0.05 tap mode\n0.4 tap quit\n", kScene));
}

TEST_F(SessionTest, ABrokenSceneDoesNotEndIt) {
  const std::string broken = folder_.write("broken.gltf", "{").string();
  const std::string scenes = broken + " " + kScene;
  const std::string card = last_frame("", "--frames 3 " + scenes);
  const std::string after = last_frame("0.05 tap scene\n", "--frames 20 " + scenes);
  EXPECT_FALSE(card.empty());
  EXPECT_NE(card, after);
}

TEST_F(SessionTest, ReportsItsPresses) {
  const std::string script = folder_.write("script", "0.02 tap mode\n0.05 tap hud\n").string();
  const ProgramRun run =
      run_program("run --display headless --size 80x60 --frames 9 --json --script " + script + " " + kScene);
  ASSERT_EQ(run.status, 0) << run.err;
  const nlohmann::json report = nlohmann::json::parse(run.out);
  EXPECT_EQ(report["frames"], 9);
  EXPECT_EQ(report["presses"], 2);
  EXPECT_GT(report["slowest_press_ms"], 0.0);
}

TEST_F(SessionTest, EndsOnATerminationSignal) {
  const ProgramRun run = run_program("run --display headless --frames 1000000000 --size 80x60 --json " +
                                     kScene + " & pid=$!; sleep 2; kill -TERM $pid; wait $pid; exit $?; #");
  EXPECT_EQ(run.status, 0) << run.err;
}

}  // namespace
}  // namespace vitrine
