// The program as a service: a manager that listens, signals, and a folder that is the only one to write into.
#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include "firmware/program_runs.h"
#include "source_file.h"

namespace vitrine {
namespace {

using testing::HasSubstr;

/// A manager's socket. Its time is bounded by the test's timeout alone.
class Manager {
 public:
  explicit Manager(const std::filesystem::path& path) : descriptor_(socket(AF_UNIX, SOCK_DGRAM, 0)) {
    sockaddr_un name{};
    name.sun_family = AF_UNIX;
    path.string().copy(static_cast<char*>(name.sun_path), sizeof(name.sun_path) - 1);
    if (bind(descriptor_, reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0)
      throw std::runtime_error("no socket");
  }
  ~Manager() { close(descriptor_); }
  Manager(const Manager&) = delete;
  Manager& operator=(const Manager&) = delete;

  /// The next message with `part` in it.
  [[nodiscard]] std::string await(const std::string& part) const {
    while (true) {
      char text[4096];
      const ssize_t length = recv(descriptor_, text, sizeof text, 0);
      if (length <= 0) return "";
      const std::string message(text, static_cast<std::size_t>(length));
      if (message.find(part) != std::string::npos) return message;
    }
  }

 private:
  int descriptor_;
};

class ServiceTest : public testing::Test {
 protected:
  void start(const std::string& options) {
    process_ = fork();
    if (process_ != 0) return;
    setenv("NOTIFY_SOCKET", (folder_.path() / "notify").c_str(), 1);
    setenv("WATCHDOG_USEC", "300000", 1);
    setenv("RUNTIME_DIRECTORY", runtime_.path().c_str(), 1);
    const std::string command = "cd '" + working_.path().string() + "' && exec '" VITRINE_PROGRAM "' run " +
                                options + " 2>'" + (folder_.path() / "err").string() + "'";
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  [[nodiscard]] int end() const {
    kill(process_, SIGTERM);
    int status = 0;
    waitpid(process_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  [[nodiscard]] std::string errors() const { return file_content(folder_.path() / "err"); }

  TemporaryFolder folder_;
  TemporaryFolder runtime_;
  TemporaryFolder working_;
  Manager manager_{folder_.path() / "notify"};
  pid_t process_ = 0;
};

constexpr const char* kHeadless = " --display headless --frames 1000000000 --size 64x48 ";
const std::string kScene = source_file("scenes/cornell.gltf");

TEST_F(ServiceTest, TellsItsManagerAndReloads) {
  const std::string config = folder_.write("kiosk.toml", "max_spp = 4\n");
  start(kHeadless + ("--config " + config + " ") + kScene);
  EXPECT_THAT(manager_.await("READY=1"), HasSubstr("STATUS=cornell"));
  EXPECT_EQ(manager_.await("WATCHDOG"), "WATCHDOG=1");

  (void)folder_.write("kiosk.toml", "max_spq = 4\n");
  kill(process_, SIGHUP);
  EXPECT_THAT(manager_.await("RELOADING"), HasSubstr("MONOTONIC_USEC="));
  EXPECT_THAT(manager_.await("READY=1"), HasSubstr("did you mean 'max_spp'?"));
  EXPECT_EQ(manager_.await("WATCHDOG"), "WATCHDOG=1") << "it goes on";
  EXPECT_THAT(errors(), HasSubstr("kiosk.toml: line 1, column 1: unknown key 'max_spq'"));

  (void)folder_.write("kiosk.toml", "[health]\nevery_s = 0.5\n");
  kill(process_, SIGHUP);
  EXPECT_THAT(manager_.await("READY=1"), HasSubstr("read anew"));
  EXPECT_EQ(end(), 0);
  EXPECT_THAT(manager_.await("STOPPING"), HasSubstr("STOPPING=1"));
}

TEST_F(ServiceTest, WritesIntoItsRuntimeFolderAlone) {
  const std::string script = folder_.write("script", "0.1 tap screenshot\n");
  start(kHeadless + ("--script " + script + " ") + kScene);
  while (!std::filesystem::exists(runtime_.path() / "vitrine.prom") ||
         std::distance(std::filesystem::directory_iterator(runtime_.path()), {}) < 2)
    std::this_thread::yield();
  EXPECT_EQ(end(), 0);
  EXPECT_TRUE(std::filesystem::is_empty(working_.path()));
  EXPECT_THAT(file_content(runtime_.path() / "vitrine.prom"), HasSubstr("vitrine_frames_total"));
}

TEST_F(ServiceTest, ABadConfigLeavesItsLastWordsForTheSafeBox) {
  const std::string config = folder_.write("kiosk.toml", "dispaly = 1\n");
  start("--config " + config);
  int status = 0;
  waitpid(process_, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_THAT(file_content(runtime_.path() / "last-words"), HasSubstr("did you mean 'display'?"));
  start(kHeadless + ("--safe --config " + config));
  EXPECT_THAT(manager_.await("READY=1"), HasSubstr("STATUS=an error card over built-in"));
  EXPECT_EQ(end(), 0);
  EXPECT_THAT(errors(), HasSubstr("did you mean 'display'?"));
}

TEST(CheckConfig, SaysOkOrWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string good = folder.write("good.toml", "[[gpio]]\nbutton = 'scene'\nline = 'GPIO5'\n");
  const ProgramRun ok = run_program("run --check-config --config " + good + " " + kScene);
  EXPECT_EQ(ok.status, 0) << ok.err;
  EXPECT_THAT(ok.out, HasSubstr("ok; display auto, 1 scenes"));
  const std::string bad = folder.write("bad.toml", "playlist = 'none.toml'\n");
  const ProgramRun wrong = run_program("run --check-config --config " + bad);
  EXPECT_EQ(wrong.status, 3);
  EXPECT_THAT(wrong.err, HasSubstr("none.toml: cannot be read"));
}

}  // namespace
}  // namespace vitrine
