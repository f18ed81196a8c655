// An iteration that is cut short is as if it had never begun, wherever it is cut.
#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <vector>

#include "core/colony/colony.h"
#include "tests/core/base/counting_time.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

class CutIteration : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Colony, CutIteration, testing::ValuesIn(colonies()), by_algorithm);

/// The trail after each iteration, and the curves.
struct Trails {
  std::vector<std::vector<double>> pheromone;
  Convergence curves;

  Observer observer(const Grid& grid) {
    return [this, &grid](const GridProgress& seen) {
      auto& trail = pheromone.emplace_back();
      for (const Cell c : cells_of(grid)) trail.push_back(seen.pheromone(c));
    };
  }
  void add(const Convergence& run) {
    const auto append = [](auto& to, const auto& more) {
      to.insert(to.end(), more.begin(), more.end());
    };
    append(curves.best, run.best);
    append(curves.iteration_best, run.iteration_best);
    append(curves.steps, run.steps);
    append(curves.arrived, run.arrived);
    curves.iterations += run.iterations;
  }
};

TEST_P(CutIteration, LeavesNeitherTrailNorRecord) {
  constexpr int kIterations = 4, kCuts = 80;
  const Planner planner(blobs(26, 22, 5));
  const Request request = far_apart(planner);
  int cut_runs = 0;
  for (const StraightDeposit deposit : {StraightDeposit::all, StraightDeposit::improving}) {
    Params params = quick(GetParam());
    params.ants = std::min(params.ants, 5);
    params.agreement = 0;
    if (params.straight_deposit != StraightDeposit::none) params.straight_deposit = deposit;
    const auto run = [&](SurvivingColony& colony, int iterations, const StopCondition& stop,
                         Trails& into) {
      Result result = colony.run(request.start, iterations, stop, into.observer(planner.grid()));
      into.add(result.curves);
      return result;
    };
    Trails uncut;
    const CountingTime never(INT_MAX);
    SurvivingColony whole(planner.grid(), request.goal, params);
    ASSERT_EQ(run(whole, kIterations, never.is_up(), uncut).curves.iterations, kIterations);
    const int polls = never.polls();
    for (int i = 0; i < std::min(kCuts, polls); ++i) {
      const CountingTime time(static_cast<int>(std::int64_t{polls} * i / std::min(kCuts, polls)));
      params.threads = 1 + i % 2;
      SurvivingColony colony(planner.grid(), request.goal, params);
      Trails trails;
      const Result cut = run(colony, kIterations, time.is_up(), trails);
      if (cut.status != Status::limit) continue;
      ++cut_runs;
      EXPECT_LT(cut.curves.iterations, kIterations);
      const Result rest = run(colony, kIterations - cut.curves.iterations, {}, trails);
      EXPECT_EQ(trails.pheromone, uncut.pheromone) << i;
      EXPECT_EQ(trails.curves.best, uncut.curves.best) << i;
      EXPECT_EQ(trails.curves.iteration_best, uncut.curves.iteration_best) << i;
      EXPECT_EQ(trails.curves.steps, uncut.curves.steps) << i;
      EXPECT_EQ(trails.curves.arrived, uncut.curves.arrived) << i;
      // What a cut iteration found is kept.
      if (!cut.path.empty()) {
        EXPECT_LE(rest.length, cut.length) << i;
      }
    }
  }
  EXPECT_GT(cut_runs, 30);
}

TEST_P(CutIteration, AnObserverComesTooLateOnceTheSearchHasEnded) {
  // On a corridor all ants take one way: with `agreement` the colony settles before its last.
  for (const bool settles : {false, true}) {
    const Planner planner(settles ? Grid(12, 1) : blobs(26, 22, 5));
    const Request request =
        settles ? Request{.start = {0, 0}, .goal = {11, 0}} : far_apart(planner);
    Params params = quick(GetParam());
    params.iterations = 5;
    params.agreement = settles ? 3 : 0;
    const Result whole = planner.plan(request, params);
    ASSERT_EQ(whole.status, Status::solved);
    ASSERT_EQ(whole.curves.iterations, settles ? 3 : 5);
    for (int at = 0; at < whole.curves.iterations; ++at) {
      const Result result =
          planner.plan(request, params, {.observer = [&](const GridProgress& seen) {
                         return seen.iteration == at ? Go::stop : Go::on;
                       }});
      EXPECT_EQ(result.curves.iterations, at + 1);
      const bool last = at + 1 == whole.curves.iterations;
      EXPECT_EQ(result.status, last ? Status::solved : Status::interrupted) << at;
      if (last) {
        EXPECT_EQ(result.path, whole.path);
      }
    }
  }
}

}  // namespace
}  // namespace lasius
