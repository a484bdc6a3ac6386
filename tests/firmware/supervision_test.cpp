// What the service manager is told and when, the governor and the health file, on injected time and readings;
// and the idle box.
#include "supervision.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware/temporary_folder.h"
#include "health_file.h"
#include "manners.h"
#include "thermal_sensor.h"

namespace vitrine {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Clock::time_point at(double s) {
  return Clock::time_point{} + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s));
}

TEST(Supervision, ReadyWithTheFirstFrameAndAliveByFrames) {
  std::vector<std::string> said;
  Supervision supervision([&](const std::string& message) { said.push_back(message); }, seconds(3));
  supervision.presented(at(0), "a");
  EXPECT_THAT(said, ElementsAre("READY=1\nSTATUS=a"));
  supervision.presented(at(0.9), "b");
  EXPECT_EQ(said.size(), 1U) << "a third of the time has not passed";
  supervision.presented(at(1.0), "b");
  supervision.presented(at(1.1), "b");
  EXPECT_THAT(said, ElementsAre("READY=1\nSTATUS=a", "WATCHDOG=1"));
  supervision.presented(at(60), "c");
  EXPECT_THAT(said, ElementsAre("READY=1\nSTATUS=a", "WATCHDOG=1", "WATCHDOG=1", "STATUS=c"));
}

TEST(Supervision, WaitingForAScreenExtendsTheStartAndFeedsTheWatchdog) {
  std::vector<std::string> said;
  Supervision supervision([&](const std::string& message) { said.push_back(message); }, seconds(3));
  supervision.waiting_for_screen(at(0));
  supervision.waiting_for_screen(at(1));
  EXPECT_THAT(said, ElementsAre("EXTEND_TIMEOUT_USEC=30000000", "STATUS=waiting for a screen"));
  supervision.waiting_for_screen(at(11));
  EXPECT_EQ(said[2], "EXTEND_TIMEOUT_USEC=30000000");
  said.clear();
  supervision.presented(at(12), "a");
  EXPECT_THAT(said, ElementsAre("READY=1\nSTATUS=a"));
  said.clear();
  supervision.waiting_for_screen(at(13.5));
  EXPECT_THAT(said, ElementsAre("WATCHDOG=1"));
}

TEST(Supervision, AWatchdogForAnotherProcessIsNone) {
  EXPECT_EQ(watchdog_time("2000000", nullptr), seconds(2));
  EXPECT_EQ(watchdog_time("2000000", "1"), std::nullopt);
  EXPECT_EQ(watchdog_time(nullptr, nullptr), std::nullopt);
  EXPECT_EQ(watchdog_time("soon", nullptr), std::nullopt);
  EXPECT_EQ(watchdog_time("0", nullptr), std::nullopt);
}

TEST(ThermalGovernor, WorksLessWhenHotAndRecoversBelowALowerTemperature) {
  ThermalGovernor governor({.hot_c = 80.0, .cool_c = 70.0});
  governor.take({.temperature_c = 79.9, .throttled = {}}, at(0));
  EXPECT_EQ(governor.duty(), 1.0);
  governor.take({.temperature_c = 80.0, .throttled = {}}, at(1));
  EXPECT_EQ(governor.duty(), 0.5);
  governor.take({.temperature_c = 90.0, .throttled = {}}, at(2));
  EXPECT_EQ(governor.duty(), 0.5) << "a step has time to show what it does";
  governor.take({.temperature_c = 75.0, .throttled = {}}, at(20));
  EXPECT_EQ(governor.duty(), 0.5) << "in between it stays";
  for (int i = 3; i < 12; ++i) governor.take({.temperature_c = 90.0, .throttled = {}}, at(10.0 * i));
  EXPECT_EQ(governor.duty(), 1.0 / 16.0);
  governor.take({}, at(200));
  EXPECT_EQ(governor.duty(), 1.0 / 16.0) << "no reading, no change";
  for (int i = 21; i < 30; ++i) governor.take({.temperature_c = 60.0, .throttled = {}}, at(10.0 * i));
  EXPECT_EQ(governor.duty(), 1.0);
  governor.take({.temperature_c = 60.0, .throttled = true}, at(400));
  EXPECT_EQ(governor.duty(), 0.5);
}

TEST(ThermalSensor, FindsTheProcessorsZone) {
  const TemporaryFolder folder;
  for (const auto& [zone, type] : {std::pair{"thermal_zone0", "acpitz"}, {"thermal_zone10", "cpu-thermal"}}) {
    std::filesystem::create_directory(folder.path() / zone);
    (void)folder.write(std::string(zone) + "/type", type);
    (void)folder.write(std::string(zone) + "/temp", "51234\n");
  }
  const auto zone = find_thermal_zone(folder.path());
  EXPECT_EQ(zone, folder.path() / "thermal_zone10/temp");
  EXPECT_EQ(read_thermals(zone, std::nullopt), (ThermalReading{.temperature_c = 51.234, .throttled = {}}));
  EXPECT_EQ(find_thermal_zone(folder.path() / "none"), std::nullopt);
  EXPECT_EQ(read_thermals(std::nullopt, folder.write("t", "0x50000\n")).throttled, false) << "it was, once";
  EXPECT_EQ(read_thermals(std::nullopt, folder.write("t", "0x50004\n")).throttled, true);
  EXPECT_EQ(read_thermals(folder.path() / "none", folder.write("t", "what")), ThermalReading{});
}

TEST(HealthFile, IsReplacedWholeAndEscaped) {
  const TemporaryFolder folder;
  Health health;
  health.frames = 3;
  health.scene = "a\"b";
  health.mode = "nee";
  for (int i = 1; i <= 100; ++i) health.frame_times.add(std::chrono::milliseconds(i));
  replace_file(folder.path() / "v.prom", prometheus_text(health));
  replace_file(folder.path() / "v.prom", prometheus_text(health));
  std::ifstream file(folder.path() / "v.prom");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(text, HasSubstr("\nvitrine_showing{scene=\"a\\\"b\",mode=\"nee\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("\nvitrine_frame_seconds_bucket{le=\"0.04\"} 40\n"));
  EXPECT_THAT(text, HasSubstr("\nvitrine_recent_frame_seconds{quantile=\"0.99\"} 0.099\n"));
  EXPECT_THAT(text, Not(HasSubstr("temperature")));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "v.prom.new"));
  EXPECT_THROW(replace_file(folder.path() / "no/v.prom", text), std::runtime_error);
}

TEST(IdleWatch, ResetsOnceAndToursUntilTouched) {
  IdleWatch watch({.after = seconds(20), .every = seconds(5), .reset = seconds(10)}, at(0));
  EXPECT_EQ(watch.due(at(9.9)), IdleStep::kNone);
  EXPECT_EQ(watch.due(at(10)), IdleStep::kReset);
  EXPECT_EQ(watch.due(at(11)), IdleStep::kNone);
  EXPECT_EQ(watch.due(at(20)), IdleStep::kBegin);
  EXPECT_EQ(watch.due(at(24)), IdleStep::kNone);
  EXPECT_EQ(watch.due(at(25)), IdleStep::kNext);
  watch.touched(at(26));
  EXPECT_FALSE(watch.touring());
  EXPECT_EQ(watch.due(at(35)), IdleStep::kNone);
  EXPECT_EQ(watch.due(at(36)), IdleStep::kReset);
  IdleWatch nothing({}, at(0));
  EXPECT_EQ(nothing.due(at(1e6)), IdleStep::kNone);
}

TEST(Manners, DimBySpansOverMidnightUntilAPress) {
  TimeOfDay now{0};
  MannersSettings settings;
  settings.dim = {{*parse_time_of_day("22:00"), *parse_time_of_day("07:00"), 0.2},
                  {*parse_time_of_day("01:00"), *parse_time_of_day("02:00"), 0.0}};
  settings.time_of_day = [&now] { return now; };
  settings.pixel_shift = true;
  Manners manners(settings, at(0));
  const auto brightness = [&](const char* time) {
    now = *parse_time_of_day(time);
    return manners.brightness(at(100));
  };
  EXPECT_EQ(brightness("21:59"), 1.0);
  EXPECT_EQ(brightness("22:00"), 0.2);
  EXPECT_EQ(brightness("00:30"), 0.2);
  EXPECT_EQ(brightness("01:30"), 0.0);
  EXPECT_EQ(brightness("07:00"), 1.0);
  now = *parse_time_of_day("23:00");
  manners.touched(at(100));
  EXPECT_EQ(manners.brightness(at(159)), 1.0);
  EXPECT_EQ(manners.brightness(at(160)), 0.2);
  EXPECT_EQ(manners.label_offset(at(59)), PixelOffset{});
  EXPECT_NE(manners.label_offset(at(61)), PixelOffset{});
  for (const char* bad : {"24:00", "7:00", "07:60", "0700", "07:0x", ""})
    EXPECT_FALSE(parse_time_of_day(bad));
}

}  // namespace
}  // namespace vitrine
