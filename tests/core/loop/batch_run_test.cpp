#include "core/loop/batch_run.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <functional>
#include <stop_token>
#include <thread>

namespace lasius {
namespace {

// A worker holds all that a plan works with.
TEST(BatchRun, MakesNoMoreWorkersThanThereAreTasks) {
  for (const auto& [requests, seeds, most] : {std::array{2, 1, 2}, {1, 3, 3}, {20, 2, 8}}) {
    std::atomic<int> workers = 0, done = 0;
    const auto make_worker = [&]() -> BatchWorker {
      ++workers;
      return [&](BatchTask&) { return [&] { ++done; }; };
    };
    const BatchOptions options{.threads = 8, .seeds = seeds};
    run_tasks(
        static_cast<std::size_t>(requests), 1, options, [](std::size_t) { return StopCondition(); },
        make_worker);
    EXPECT_EQ(done, requests * seeds);
    EXPECT_LE(workers, most);
  }
}

// Answers are given on in order, so the others go ahead of a task only so far.
TEST(BatchRun, AStopEndsThoseThatWaitForAnEarlierAnswer) {
  std::stop_source stop;
  std::atomic<int> ahead = 0, received = 0;
  std::atomic<bool> begun = false;        // the first one
  constexpr int kAhead = 64 + 8 * 3 - 1;  // of the first one, with three threads
  const auto make_worker = [&]() -> BatchWorker {
    return [&](BatchTask& task) -> std::function<void()> {
      if (task.index == 0) {
        begun = true;
        begun.notify_all();
        while (!task.stop.token.stop_requested()) std::this_thread::yield();
      } else {
        ++ahead;
        ahead.notify_all();
      }
      return [&] { ++received; };
    };
  };
  const std::jthread stopper([&] {
    begun.wait(false);
    for (int now; (now = ahead) < kAhead;) ahead.wait(now);
    stop.request_stop();
  });
  const auto no_stop = [](std::size_t) { return StopCondition(); };
  const BatchOptions options{.threads = 3, .token = stop.get_token()};
  EXPECT_EQ(run_tasks(1 << 20, 1, options, no_stop, make_worker), 1u + kAhead);
  EXPECT_EQ(ahead, kAhead);
  EXPECT_EQ(received, 1 + kAhead);
}

}  // namespace
}  // namespace lasius
