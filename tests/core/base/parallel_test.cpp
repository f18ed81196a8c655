#include "core/base/parallel.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace lasius {
namespace {

TEST(ThreadCount, OfOpenMpIsBounded) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(1 << 30);
  EXPECT_EQ(thread_count(0), 1024);
  omp_set_num_threads(3);
  EXPECT_EQ(thread_count(0), 3);
  omp_set_num_threads(before);
  EXPECT_EQ(thread_count(2), 2);
}

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

TEST(ThreadTeam, SharesManyLoops) {
  for (const int threads : {2, 5}) {
    std::int64_t sum = 0;
    std::atomic<bool> in_range{true};
    ThreadTeam::lead(threads, [&] {
      for (int round = 0; round < 20000; ++round) {
        const int count = round % 7, members = 1 + round % 4;
        std::array<int, 7> calls{};
        parallel_for(count, members, [&](int i, int thread) {
          ++calls[static_cast<std::size_t>(i)];  // of one thread each
          if (thread < 0 || thread >= std::min(members, threads)) in_range = false;
        });
        for (int i = 0; i < count; ++i) sum += calls[static_cast<std::size_t>(i)] == 1;
      }
    });
    EXPECT_TRUE(in_range);
    std::int64_t calls = 0;
    for (int round = 0; round < 20000; ++round) calls += round % 7;
    EXPECT_EQ(sum, calls) << threads;
  }
}

TEST(ThreadTeam, AllOfItWorks) {
  // Each call waits for the other, and gives up where one thread makes both.
  constexpr int kMostLooks = 1 << 22;
  std::atomic<int> inside{0}, met{0};
  ThreadTeam::lead(2, [&] {
    parallel_for(2, 2, [&](int, int) {
      ++inside;
      for (int looks = 0; inside < 2 && looks < kMostLooks; ++looks) std::this_thread::yield();
      met += inside == 2 ? 1 : 0;
    });
  });
  EXPECT_EQ(met, 2);
}

TEST(ThreadTeam, ThrowsOnAndGoesOn) {
  int done = 0;
  ThreadTeam::lead(3, [&] {
    for (int round = 0; round < 100; ++round) {
      const auto body = [](int i, int) {
        if (i == 3) throw std::runtime_error("three");
      };
      EXPECT_THROW(parallel_for(100, 3, body), std::runtime_error);
      ++done;
    }
  });
  EXPECT_EQ(done, 100);
  EXPECT_THROW(ThreadTeam::lead(3, [] { throw std::runtime_error("leader"); }), std::runtime_error);
  EXPECT_EQ(ThreadTeam::led_here(), nullptr);
}

TEST(ThreadTeam, OneInsideAnother) {
  std::atomic<int> calls{0};
  ThreadTeam::lead(2, [&] {
    ThreadTeam* const outer = ThreadTeam::led_here();
    ThreadTeam::lead(2, [&] {
      EXPECT_NE(ThreadTeam::led_here(), outer);
      parallel_for(10, 2, [&](int, int) { ++calls; });
    });
    EXPECT_EQ(ThreadTeam::led_here(), outer);
    parallel_for(10, 2, [&](int, int) { ++calls; });
  });
  EXPECT_EQ(calls, 20);
}

TEST(ThreadTeam, ALoopWithinALoopLosesNothing) {
  for (const int threads : {2, 5}) {
    std::atomic<int> outer{0}, inner{0};
    ThreadTeam::lead(threads, [&] {
      ThreadTeam* const team = ThreadTeam::led_here();
      for (int round = 0; round < 100; ++round) {
        parallel_for(8, threads, [&](int, int) {
          ++outer;
          parallel_for(3, threads, [&](int, int) { ++inner; });
        });
        EXPECT_EQ(ThreadTeam::led_here(), team);
      }
    });
    EXPECT_EQ(outer, 800) << threads;
    EXPECT_EQ(inner, 2400) << threads;
  }
}

}  // namespace
}  // namespace lasius
