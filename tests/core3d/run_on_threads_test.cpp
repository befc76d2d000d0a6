// SPDX-License-Identifier: GPL-3.0-or-later
#include "core3d/run_on_threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

namespace flatland::test {
namespace {

TEST(RunOnThreads, EveryThreadWorksOnce) {
  for (const std::size_t threads : {0u, 1u, 2u, 7u}) {
    std::atomic<std::size_t> calls = 0;
    runOnThreads(threads, [&] { ++calls; });
    EXPECT_EQ(calls, std::max<std::size_t>(threads, 1));
  }
}

TEST(RunOnThreads, FailuresArriveWhenAllHaveEnded) {
  std::atomic<int> ended = 0, turn = 0;
  const auto work = [&] {
    if (turn++ % 2 == 0) throw std::runtime_error("no room");
    ++ended;
  };
  EXPECT_THROW(runOnThreads(8, work), std::runtime_error);
  EXPECT_EQ(turn, 8);
  EXPECT_EQ(ended, 4);
}

}  // namespace
}  // namespace flatland::test
