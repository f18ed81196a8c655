// What a plan allocates. Apart from other tests: the thread sanitizer has an allocator of its own.
#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "tests/measures/count_allocations.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

std::int64_t allocations_of(const auto& action) {
  const auto before = allocations.load();
  action();
  return allocations - before;
}

class EveryColony : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(PlannerAllocation, EveryColony, testing::ValuesIn(colonies()),
                         by_algorithm);

struct Bounds {
  int least, most;
};
/// How often a plan allocates: the result's ten curves, an entry an iteration, as they double;
/// its path once, and perhaps again with each better one.
Bounds allocations_for(const Result& result) {
  const auto entries = static_cast<unsigned>(result.curves.iterations);
  const int once = 10 * (1 + std::bit_width(entries - 1)) + 1;
  int better = 0;
  for (std::size_t q = 1; q < entries; ++q)
    better += result.curves.best[q] < result.curves.best[q - 1];
  return {once, once + better};
}

TEST_P(EveryColony, ASecondCallOfTheSameSizeAllocatesOnlyItsResult) {
  const FarApart far;
  for (const Polish polish : {Polish::none, Polish::straight}) {
    for (const int threads : {1, 2}) {
      for (const int iterations : {1, 6}) {
        Params params = quick(GetParam());
        params.polish = polish;
        params.threads = threads;
        params.iterations = iterations;
        Workspace workspace;
        const Bounds expected = allocations_for(far.plan(params, {.workspace = &workspace}));
        // Two threads take ants as they come, so each may meet the longest walk in a later call.
        std::int64_t count = 0;
        for (int call = 0; call < (threads == 1 ? 1 : 100); ++call) {
          count = allocations_of([&] { (void)far.plan(params, {.workspace = &workspace}); });
          if (count <= expected.most) break;
        }
        const auto what = testing::Message() << iterations << " iterations, " << threads
                                             << " threads, polish " << static_cast<int>(polish);
        EXPECT_GE(count, expected.least) << what;
        EXPECT_LE(count, expected.most) << what;
      }
    }
  }
}

TEST(PlannerAllocation, OwnRulesAllocateNothingMore) {
  const FarApart far;
  std::vector<double> table(120 * 80, 1.0);
  for (const Preset preset : {Preset::usual, Preset::book}) {  // trail on cells, on arcs
    Params params("ras", preset);
    params.iterations = 6;
    params.threads = 1;
    const OwnRules own{.heuristic = table,
                       .update =
                           [](Pheromone& trail, const IterationTours& tours) {
                             trail.persist(0.9);
                             for (const int ant : tours.ranked) trail.add(tours.places_of(ant), 1);
                             trail.add(tours.best_places(), 2);
                           },
                       .schedule = [](int) { return StepWeights{}; }};
    Workspace workspace;
    const PlanOptions options{.workspace = &workspace, .own_rules = own};
    const Bounds expected = allocations_for(far.plan(params, options));
    const auto count = allocations_of([&] { (void)far.plan(params, options); });
    EXPECT_GE(count, expected.least);
    EXPECT_LE(count, expected.most);
  }
}

TEST(PlannerAllocation, TheGeneticAlgorithmKeepsItsMemory) {
  const FarApart far;
  const Params params = quick("grid-ga");
  Workspace workspace;
  const auto plan = [&] { (void)far.plan(params, {.workspace = &workspace}); };
  const auto first = allocations_of(plan);
  EXPECT_GT(first, 1000);
  EXPECT_LT(allocations_of(plan), first / 10);
}

TEST(PlannerAllocation, ProvingUnreachableTakesNoMapSizedMemory) {
  Grid grid(4096, 4096);
  for (int y = 0; y < 4096; ++y) grid.set_blocked({2000, y});
  const Planner planner(grid);
  const auto before = allocated_bytes.load();
  const Result result = planner.plan({.start = {1, 1}, .goal = {4000, 4000}}, Params("fan2004"));
  EXPECT_EQ(result.status, Status::unreachable);
  EXPECT_LT(allocated_bytes - before, 64 << 10);
}

// Whichever allocation fails, of this thread or of a team's: the call throws, and what it left in
// its workspace spoils no later plan.
TEST(PlannerAllocation, AWorkspaceOutlivesACallThatRanOutOfMemory) {
  const Planner planner(blobs(70, 50));
  const Request request = far_apart(planner);
  for (const char* algorithm : {"fan2004", "acs", "terminal-index", "grid-ga", "exact"}) {
    Params params = quick(algorithm);
    const Algorithm& read = find_algorithm(algorithm);
    if (read.has("iterations")) params.iterations = 2;
    if (read.has("ants")) params.ants = 10;
    if (read.has("population")) params.population = 10;
    const Result expected = planner.plan(request, params);
    Params before = quick("cong2009");  // with four neighbours, and tiles of another shape
    before.iterations = 2;
    for (const int threads : {1, 2}) {
      params.threads = threads;
      bool failed = true;
      std::int64_t n = 0;
      for (; failed; n += 1 + n / 4) {
        Workspace workspace;
        if (n % 2 == 1) (void)planner.plan(request, before, {.workspace = &workspace});
        failing_allocation = allocations + n;
        try {
          (void)planner.plan(request, params, {.workspace = &workspace});
          failed = false;
        } catch (const std::bad_alloc&) {
        }
        failing_allocation = -1;
        const Result again = planner.plan(request, params, {.workspace = &workspace});
        EXPECT_EQ(again.path, expected.path) << algorithm << " " << n;
        EXPECT_EQ(again.curves.mean, expected.curves.mean) << algorithm << " " << n;
      }
      EXPECT_GT(n, 10) << algorithm;  // sanitizers count no realloc
    }
  }
}

}  // namespace
}  // namespace lasius
