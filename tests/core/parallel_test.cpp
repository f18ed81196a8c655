#include "parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <vector>

namespace lasius {
namespace {

TEST(ParallelFor, CallsEachOnceFromThreadsInRange) {
  for (const int threads : {0, 1, 2, 5}) {
    for (const int count : {0, 1, 2, 1000}) {
      std::vector<std::atomic<int>> calls(static_cast<std::size_t>(count));
      std::atomic<bool> in_range{true};
      parallel_for(count, threads, [&](int i, int thread) {
        ++calls[static_cast<std::size_t>(i)];
        if (thread < 0 || thread >= std::max(threads, 1)) in_range = false;
      });
      EXPECT_TRUE(in_range);
      for (const auto& c : calls) EXPECT_EQ(c, 1) << threads << " threads, " << count;
    }
  }
}

TEST(ParallelFor, ThreadsOfOneNumberNeverMeet) {
  std::array<std::mutex, 4> busy;
  std::atomic<int> met{0};
  parallel_for(2000, 4, [&](int, int thread) {
    const std::unique_lock lock(busy[static_cast<std::size_t>(thread)], std::try_to_lock);
    if (!lock) ++met;
  });
  EXPECT_EQ(met, 0);
}

TEST(ParallelFor, ThrowsOnAndBeginsNoMore) {
  for (const int threads : {1, 2, 5}) {
    std::atomic<int> after{0};
    std::atomic<bool> thrown{false};
    const auto body = [&](int i, int) {
      // A thread that throws has noted it, so it begins no further call.
      if (thrown) {
        ++after;
        throw std::runtime_error("after");
      }
      if (i == 3) {
        thrown = true;
        throw std::runtime_error("three");
      }
    };
    EXPECT_THROW(parallel_for(1 << 20, threads, body), std::runtime_error);
    EXPECT_LE(after, threads - 1);
  }
}

}  // namespace
}  // namespace lasius
