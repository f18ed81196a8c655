// What a plan allocates. Apart from the other tests of plans: the thread sanitizer has an allocator
// of its own.
#include <gtest/gtest.h>

#include "tests/core/planning.h"
#include "tests/count_allocations.h"

namespace lasius {
namespace {

class EveryColony : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(PlannerAllocation, EveryColony, testing::ValuesIn(kColonies));

TEST_P(EveryColony, ASecondCallOfTheSameSizeAllocatesOnlyItsResult) {
  const Planner planner(blobs());
  const Request request = far_apart(planner);
  Params params = quick(GetParam());
  params.threads = 1;
  Workspace workspace;
  (void)planner.plan(request, params, &workspace);
  params.iterations = 3;
  const auto count = [&] {
    const auto before = allocations.load();
    (void)planner.plan(request, params, &workspace);
    return allocations - before;
  };
  const auto three = count();
  EXPECT_LT(three, 40);
  params.iterations = 6;
  EXPECT_LT(count() - three, 12);  // the curves grow, nothing else
}

TEST(PlannerAllocation, ProvingUnreachableTakesNoMapSizedMemory) {
  Grid grid(4096, 4096);
  for (int y = 0; y < 4096; ++y) grid.set_blocked({2000, y});
  const Planner planner(grid);
  const auto before = allocated_bytes.load();
  const Result result = planner.plan({.start = {1, 1}, .goal = {4000, 4000}}, defaults("fan2004"));
  EXPECT_EQ(result.status, Status::unreachable);
  EXPECT_LT(allocated_bytes - before, 64 << 10);
}

}  // namespace
}  // namespace lasius
