// How the program ends when another thread is at something that cannot be stopped.
#include "exit_status.h"

#include <iostream>
#include <thread>

#include <gtest/gtest.h>

namespace vitrine {
namespace {

TEST(ExitStatusDeathTest, LeavingWaitsForNobodyAndLosesNoOutput) {
  const auto leave = [] {
    std::cout.rdbuf(std::cerr.rdbuf());  // what a death test looks at
    std::thread([] {
      while (true) std::this_thread::yield();
    }).detach();
    std::cout << "printed";
    leave_now(kBadInput);
  };
  EXPECT_EXIT(leave(), testing::ExitedWithCode(kBadInput), "printed");
}

}  // namespace
}  // namespace vitrine
