#include "tools/console/team.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace lasius::tool {
namespace {

TEST(Team, EveryNumberOnceForAnyNumberOfThreads) {
  for (const int threads : {1, 2, 5}) {
    std::vector<std::atomic<int>> seen(100);
    std::atomic<int> workers{0};
    share_out(seen.size(), threads, [&] {
      ++workers;
      return [&](std::size_t i) { ++seen[i]; };
    });
    for (const auto& count : seen) EXPECT_EQ(count, 1);
    EXPECT_EQ(workers, threads);
  }
  share_out(0, 3, [] { return [](std::size_t) { FAIL() << "nothing to do"; }; });
}

TEST(Team, WhatAWorkerThrowsComesOut) {
  for (const int threads : {1, 3}) {
    std::atomic<int> done{0};
    const auto work = [&](std::size_t i) {
      if (i == 4) throw std::runtime_error("four");
      ++done;
    };
    EXPECT_THROW(share_out(10, threads, [&] { return work; }), std::runtime_error);
    EXPECT_LT(done, 10);
    if (threads == 1) {
      EXPECT_EQ(done, 4) << "nothing is begun after it";
    }
  }
}

}  // namespace
}  // namespace lasius::tool
