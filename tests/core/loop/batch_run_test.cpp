#include "core/loop/batch_run.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>

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

}  // namespace
}  // namespace lasius
