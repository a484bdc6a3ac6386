// Buttons on lines that tell what the test wants, come late and go away: nothing is lost, and what is missing
// is told. What libgpiod and the kernel make of real lines is seen in tests/rig.
#include "gpio_buttons.h"

#include <array>
#include <cerrno>
#include <deque>
#include <map>
#include <stdexcept>
#include <system_error>

#include <gtest/gtest.h>
#include <unistd.h>

namespace vitrine {
namespace {

using std::chrono::milliseconds;

/// The contacts of a board, by line. A line is readable while its pipe holds a byte an edge.
struct Wires {
  struct Wire {
    std::array<int, 2> pipe{};
    std::deque<LineEdge> edges;
    bool level = false;
    bool present = true;
    bool debounced = false;
  };
  std::map<std::string, Wire> all;

  Wires() {
    for (const char* line : {"A", "B"}) {
      if (pipe(all[line].pipe.data()) != 0) throw std::runtime_error("no pipe");
    }
  }
  ~Wires() {
    for (const auto& [line, wire] : all) {
      close(wire.pipe[0]);
      close(wire.pipe[1]);
    }
  }
  Wires(const Wires&) = delete;
  Wires& operator=(const Wires&) = delete;

  void change(const std::string& line, bool level, Clock::time_point time) {
    Wire& wire = all.at(line);
    wire.level = level;
    wire.edges.push_back({level, time});
    ASSERT_EQ(write(wire.pipe[1], "e", 1), 1);
  }
  void unplug(const std::string& line) {
    all.at(line).present = false;
    ASSERT_EQ(write(all.at(line).pipe[1], "x", 1), 1);  // as a chip that is gone, it is readable
  }
};

class TestLine final : public RequestedLine {
 public:
  explicit TestLine(Wires::Wire& wire) : wire_(wire) {}

  [[nodiscard]] int descriptor() const override { return wire_.pipe[0]; }
  std::vector<LineEdge> edges() override {
    if (!wire_.present) throw std::system_error(ENODEV, std::generic_category());
    char byte = 0;
    if (read(wire_.pipe[0], &byte, 1) != 1) throw std::system_error(errno, std::generic_category());
    const LineEdge edge = wire_.edges.front();
    wire_.edges.pop_front();
    return {edge};
  }
  bool active() override { return wire_.level; }
  [[nodiscard]] bool debounced() const override { return wire_.debounced; }

 private:
  Wires::Wire& wire_;
};

class GpioButtonsTest : public testing::Test {
 protected:
  [[nodiscard]] GpioButtons buttons() {
    const std::vector<GpioLine> lines{
        {.button = "scene", .chip = "", .line = "A", .debounce = milliseconds(5)},
        {.button = "mode", .chip = "", .line = "B", .debounce = milliseconds(5)}};
    return GpioButtons(lines,
                       [this](const GpioLine& line, const GpioInventory&) -> std::unique_ptr<RequestedLine> {
                         Wires::Wire& wire = wires_.all.at(line.line);
                         if (!wire.present)
                           throw std::runtime_error("button '" + line.button + "': no line; wire one");
                         return std::make_unique<TestLine>(wire);
                       });
  }
  /// The next event, for which it waits as long as it takes.
  static ButtonEvent next(GpioButtons& buttons) {
    std::vector<ButtonEvent> events;
    while (events.empty()) events = buttons.poll(milliseconds(100));
    EXPECT_EQ(events.size(), 1U);
    return events.front();
  }

  Wires wires_;
};

TEST_F(GpioButtonsTest, ABouncingContactIsOnePressAtItsFirstEdge) {
  for (const bool debounced : {false, true}) {
    wires_.all.at("B").debounced = debounced;
    GpioButtons pressed = buttons();
    EXPECT_EQ(pressed.notice(), "");
    const Clock::time_point first = Clock::now();
    wires_.change("B", true, first);
    if (!debounced) {
      wires_.change("B", false, first + milliseconds(1));
      wires_.change("B", true, first + milliseconds(2));
    }
    const ButtonEvent press = next(pressed);
    EXPECT_EQ(press.button, "mode");
    EXPECT_EQ(press.edge, Edge::kPress);
    EXPECT_EQ(press.time, first);
    wires_.change("B", false, Clock::now());
    EXPECT_EQ(next(pressed).edge, Edge::kRelease);
  }
}

TEST_F(GpioButtonsTest, ALineThatIsNotThereIsWaitedForWhileTheOthersWork) {
  wires_.all.at("A").present = false;
  GpioButtons waiting = buttons();
  EXPECT_EQ(waiting.notice(), "button 'scene': no line; wire one");
  wires_.change("B", true, Clock::now());
  EXPECT_EQ(next(waiting).button, "mode");

  wires_.all.at("A").present = true;
  while (!waiting.notice().empty()) EXPECT_TRUE(waiting.poll(milliseconds(10)).empty());
  wires_.change("A", true, Clock::now());
  EXPECT_EQ(next(waiting).button, "scene");
}

TEST_F(GpioButtonsTest, WhatIsHeldWhenItsChipGoesAwayIsReleased) {
  GpioButtons held = buttons();
  wires_.change("A", true, Clock::now());
  EXPECT_EQ(next(held).edge, Edge::kPress);
  wires_.unplug("A");
  const ButtonEvent release = next(held);
  EXPECT_EQ(release.button, "scene");
  EXPECT_EQ(release.edge, Edge::kRelease);
  EXPECT_NE(held.notice().find("button 'scene': "), std::string::npos) << held.notice();
  wires_.change("B", true, Clock::now());
  EXPECT_EQ(next(held).button, "mode");
}

TEST(GpioButtons, AMachineWithoutSuchAChipIsNoReasonToFail) {
  const std::vector<GpioLine> lines{{.button = "scene", .chip = "no-such-chip", .line = "3"}};
  GpioButtons none(lines);
  EXPECT_TRUE(none.poll(milliseconds(1)).empty());
  EXPECT_NE(none.notice().find("button 'scene': "), std::string::npos) << none.notice();
}

}  // namespace
}  // namespace vitrine
