#include "workers.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using std::chrono::milliseconds;

class WorkersTest : public testing::TestWithParam<int> {
 protected:
  Workers workers_{GetParam()};
};

TEST_P(WorkersTest, DoEveryPartOnce) {
  EXPECT_EQ(workers_.count(), GetParam());
  for (const std::size_t parts : {std::size_t{0}, std::size_t{1}, std::size_t{5}, std::size_t{1000}}) {
    std::vector<std::atomic<int>> done(parts);
    workers_.for_each(parts, [&](std::size_t i) { ++done[i]; });
    for (const std::atomic<int>& count : done) EXPECT_EQ(count, 1);
  }
}

TEST_P(WorkersTest, StartReturnsWhileThePartsAreUnderWay) {
  std::atomic<bool> go{false};
  workers_.start(3, [&](std::size_t) {
    while (!go) std::this_thread::yield();
  });
  EXPECT_FALSE(workers_.wait_for(milliseconds(5)));
  go = true;
  workers_.wait();
  EXPECT_TRUE(workers_.wait_for(milliseconds(0)));
}

TEST_P(WorkersTest, CancelEndsLongPartsAndBeginsNoOthers) {
  std::atomic<int> begun{0};
  workers_.start(1000, [&](std::size_t) {
    ++begun;
    while (!workers_.cancelled()) std::this_thread::yield();
  });
  while (begun == 0) std::this_thread::yield();
  workers_.cancel();
  EXPECT_LE(begun, GetParam());
  EXPECT_TRUE(workers_.wait_for(milliseconds(0)));

  std::atomic<int> after{0};
  workers_.for_each(10, [&](std::size_t) { after += workers_.cancelled() ? 0 : 1; });
  EXPECT_EQ(after, 10);
}

TEST_P(WorkersTest, GiveOnWhatAPartThrows) {
  const auto job = [&] {
    workers_.for_each(100, [](std::size_t i) {
      if (i == 7) throw std::runtime_error("seven");
    });
  };
  EXPECT_THROW(job(), std::runtime_error);
  std::atomic<int> after{0};
  workers_.for_each(10, [&](std::size_t) { ++after; });
  EXPECT_EQ(after, 10);
}

TEST_P(WorkersTest, EndWithAJobUnderWay) {
  std::atomic<bool> begun{false};
  Workers ending(GetParam());
  ending.start(100, [&](std::size_t) {
    begun = true;
    while (!ending.cancelled()) std::this_thread::yield();
  });
  while (!begun) std::this_thread::yield();
}

INSTANTIATE_TEST_SUITE_P(Threads, WorkersTest, testing::Values(1, 2, 7));

}  // namespace
}  // namespace vitrine
