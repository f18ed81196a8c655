#include "lasius/plan/planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <thread>

#include "kernels/base/cpu.h"
#include "lasius/base/error.h"
#include "lasius/path/path.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/base/environment_variable.h"
#include "tests/core/loop/same_result.h"
#include "tests/oracle/plane_rule.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

class EveryColony : public testing::TestWithParam<const char*> {
 protected:
  FarApart far_;
  Params params_ = quick(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Planner, EveryColony, testing::ValuesIn(colonies()), by_algorithm);

TEST_P(EveryColony, PlansAValidPathAndItsCurves) {
  const Result result = far_.plan(params_);
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_EQ(result.path.front(), centre(far_.request.start));
  EXPECT_EQ(result.path.back(), centre(far_.request.goal));
  EXPECT_EQ(path_fault(far_.planner.grid(), result.path), std::nullopt);
  EXPECT_EQ(result.length, path_length(result.path));
  EXPECT_EQ(result.curves.iterations, 15);
  ASSERT_EQ(result.curves.best.size(), 15u);
  ASSERT_EQ(result.curves.mean.size(), 15u);
  EXPECT_EQ(result.curves.best.back(), result.length);
  for (std::size_t i = 1; i < 15; ++i) EXPECT_LE(result.curves.best[i], result.curves.best[i - 1]);
  for (std::size_t i = 0; i < 15; ++i) {
    EXPECT_EQ(result.curves.arrived[i], params_.ants);  // who backtracks arrives
    EXPECT_GE(result.curves.mean[i], result.length);
  }
  EXPECT_FALSE(result.gap().has_value());
  EXPECT_FALSE(result.optimal);
}

TEST_P(EveryColony, GivesTheSamePlanWithAnyNumberOfThreads) {
  const Result one = far_.plan(params_);
  for (const int threads : {2, 5}) {
    params_.threads = threads;
    expect_same(far_.plan(params_), one);
  }
}

TEST_P(EveryColony, GivesTheSamePlanWithScalarAndVectorKernels) {
  const auto plan = [&](const char* kernels) {
    const EnvironmentVariable choice("LASIUS_KERNELS", kernels);
    return far_.plan(params_);
  };
  const Result scalar = plan("scalar");
  if (kernels::supported_isa() >= kernels::Isa::avx2) expect_same(plan("avx2"), scalar);
  EXPECT_THROW((void)plan("sse9"), Error);
  expect_same(plan(nullptr), scalar);
}

// Weights beyond what a double holds must not set kernels apart.
TEST(Planner, GivesTheSamePlanWithEveryKernelAtTheEndsOfItsExponents) {
  using Settings = std::vector<std::pair<const char*, const char*>>;
  const std::vector<std::pair<const char*, Settings>> cases = {
      {"as", {{"alpha", "11"}}},
      {"as", {{"alpha", "20"}}},
      {"terminal-index", {{"index_spread", "1"}, {"alpha", "5.119"}}},
      {"terminal-index", {{"index_spread", "1"}, {"alpha", "20"}}}};
  for (const Grid& grid : {Grid(40, 40), blobs(100, 60)}) {
    const Planner planner(grid);
    const Request request = far_apart(planner);
    for (const auto& [algorithm, settings] : cases) {
      Params params(algorithm);
      for (const auto& [name, value] : settings) set_parameter(params, name, value);
      params.dead_end = DeadEnd::backtrack;
      params.ants = 20;
      params.iterations = 100;
      const auto plan = [&](const char* kernels) {
        const EnvironmentVariable choice("LASIUS_KERNELS", kernels);
        return planner.plan(request, params);
      };
      expect_same(plan(nullptr), plan("scalar"));
    }
  }
}

TEST_P(EveryColony, SeedsGiveDifferentRunsAndWorkspacesDoNot) {
  const Result first = far_.plan(params_);
  Workspace workspace;
  expect_same(far_.plan(params_, {.workspace = &workspace}), first);
  const Planner other(blobs(90, 300, 8));
  (void)other.plan(far_apart(other), params_, {.workspace = &workspace});  // leaves its traces
  expect_same(far_.plan(params_, {.workspace = &workspace}), first);
  params_.seed = 2;
  EXPECT_NE(far_.plan(params_).curves.mean, first.curves.mean);
}

TEST_P(EveryColony, PlansWithEveryNeighbourhoodCornerRuleAndPolish) {
  const Planner planner(blobs(60, 40));
  const Request request = far_apart(planner);
  Workspace workspace;
  for (const auto neighbours :
       {Neighbours::four, Neighbours::eight, Neighbours::sixteen, Neighbours::sixteen_knight,
        Neighbours::twenty_four, Neighbours::thirty_two}) {
    for (const auto corners : {Corners::forbid, Corners::one_side, Corners::allow}) {
      if (neighbours == Neighbours::four && corners != Corners::forbid) continue;  // no diagonals
      for (const auto polish : {Polish::none, Polish::straight, Polish::taut}) {
        Params params = quick(GetParam());
        params.iterations = 2;
        params.ants = 5;
        params.neighbours = neighbours;
        params.corners = corners;
        params.polish = polish;
        params.dead_end = polish == Polish::straight ? DeadEnd::kill : params.dead_end;
        const Result result = planner.plan(request, params, {.workspace = &workspace});
        if (result.path.empty()) {
          ASSERT_EQ(params.dead_end, DeadEnd::kill);
          continue;
        }
        if (corners == Corners::allow) {
          EXPECT_EQ(path_fault(planner.grid(), result.path, corners), std::nullopt);
        } else {
          EXPECT_TRUE(rule::Checker(planner.grid()).obeys(result.path));
        }
      }
    }
  }
}

TEST(Planner, TautIsNeverLongerThanStraightAndStraightThanNone) {
  const FarApart far;
  Params params("as");  // its trails do not depend on the polish
  params.iterations = 1;
  const auto length = [&](Polish polish) {
    params.polish = polish;
    return far.plan(params).length;
  };
  const double none = length(Polish::none), straight = length(Polish::straight);
  EXPECT_LT(straight, none);
  EXPECT_LE(length(Polish::taut), straight);
}

TEST(Planner, StartAndGoalOutsideOrBlockedAreAnAnswer) {
  const Grid grid = with_blocked(10, 10, {{4, 4}});
  const Planner planner(grid);
  const auto error = [&](Cell start, Cell goal) {
    const Result result = planner.plan({.start = start, .goal = goal});
    EXPECT_EQ(result.status, Status::invalid);
    EXPECT_TRUE(result.path.empty());
    EXPECT_TRUE(std::isnan(result.length));
    return result.error;
  };
  EXPECT_EQ(error({4, 4}, {0, 0}), "start (4, 4) is blocked; the nearest free cell is (4, 3)");
  EXPECT_EQ(error({0, 0}, {10, 3}),
            "goal (10, 3) is outside the map; the nearest free cell is (9, 3)");
  constexpr int kLeast = std::numeric_limits<int>::min(), kMost = std::numeric_limits<int>::max();
  EXPECT_EQ(error({kLeast, 5}, {0, 0}),
            "start (-2147483648, 5) is outside the map; the nearest free cell is (0, 5)");
  EXPECT_EQ(error({kMost, kLeast}, {0, 0}),
            "start (2147483647, -2147483648) is outside the map; the nearest free cell is (9, 0)");
  const Grid full = with_blocked(2, 1, {{0, 0}, {1, 0}});
  EXPECT_EQ(Planner(full).plan({.start = {0, 0}, .goal = {1, 0}}).error,
            "start (0, 0) is blocked; the map has no free cell");
}

TEST(Planner, ATargetGapIsNotNegative) {
  const Planner planner(Grid(5, 5));
  for (const double gap : {-0.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(planner.plan({.start = {0, 0}, .goal = {4, 4}, .target_gap = gap}), Error);
  }
}

TEST(Planner, StartEqualToGoalIsAPathOfLengthZero) {
  const Result result = Planner(Grid(5, 5)).plan({.start = {2, 2}, .goal = {2, 2}});
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_EQ(result.path, std::vector<Point>{(Point{2.5, 2.5})});
  EXPECT_EQ(result.length, 0);
  EXPECT_EQ(result.gap(), 0);
}

TEST(Planner, UnreachableGoalsAreProvenUnderTheRuleInForce) {
  Grid grid(20, 20);
  for (int y = 0; y < 20; ++y) grid.set_blocked({y, y});  // a wall of diagonal neighbours
  const Planner planner(grid);
  const Request request{.start = {10, 2}, .goal = {2, 10}};
  Params params = quick("as");
  EXPECT_EQ(planner.plan(request, params).status, Status::unreachable);
  EXPECT_NE(planner.plan(request, params).error, "");
  params.corners = Corners::allow;
  EXPECT_EQ(planner.plan(request, params).status, Status::solved);
}

TEST(Planner, CellsThatFourNeighboursJoinNeedNoLabelsOfEight) {
  Grid grid(20, 20);
  for (int y = 0; y < 20; ++y) grid.set_blocked({y, y});
  const Planner planner(grid);
  const auto four = planner.footprint().components;
  Params params = quick("as");
  params.corners = Corners::allow;
  EXPECT_TRUE(planner.connected({10, 2}, {18, 3}, Corners::allow));
  EXPECT_EQ(planner.plan({.start = {10, 2}, .goal = {18, 3}}, params).status, Status::solved);
  EXPECT_EQ(planner.footprint().components, four);
  EXPECT_FALSE(planner.connected({10, 2}, {2, 10}));
  EXPECT_TRUE(planner.connected({10, 2}, {2, 10}, Corners::allow));
  EXPECT_GT(planner.footprint().components, four);
}

TEST(Planner, UnreachableNeedsNoTimeAtAll) {
  const CountingTime time(0);  // any poll at all would end the call with another status
  const Grid grid = walled(1000, 1000, {{500, 0, 1, 1000}});
  const Planner planner(grid);
  const Result result =
      planner.plan({.start = {1, 1}, .goal = {900, 900}, .stop = time.is_up()}, Params("fan2004"));
  EXPECT_EQ(result.status, Status::unreachable);
  EXPECT_EQ(time.polls(), 0);
}

TEST_P(EveryColony, AnExpiredDeadlineEndsTheCallWithTheBestPathSoFar) {
  bool with = false, without = false, in_the_first_iteration = false;
  for (int readings = 0;; readings = readings * 9 / 8 + 1) {
    const CountingTime time(readings);
    far_.request.stop = time.is_up();
    const Result result = far_.plan(params_);
    if (result.status == Status::solved) break;
    ASSERT_EQ(result.status, Status::limit) << readings;
    EXPECT_EQ(result.limit, Limit::time);
    EXPECT_LE(time.polls() - readings, params_.ants + 40);
    EXPECT_EQ(result.curves.best.size(), static_cast<std::size_t>(result.curves.iterations));
    (result.path.empty() ? without : with) = true;
    in_the_first_iteration |= result.curves.iterations == 0 && !result.path.empty();
    if (!result.path.empty()) {
      EXPECT_EQ(path_fault(far_.planner.grid(), result.path), std::nullopt);
    }
  }
  EXPECT_TRUE(with && without && in_the_first_iteration);
}

TEST(Planner, CopiesShareWhatIsPrepared) {
  std::optional<Planner> planner(blobs());
  const Request request = far_apart(*planner);
  const Result expected = planner->plan(request);
  Planner copy = *planner;
  EXPECT_EQ(&copy.grid(), &planner->grid());
  const auto four = copy.footprint().components;
  ASSERT_TRUE(copy.label(Corners::allow));
  EXPECT_GT(planner->footprint().components, four);
  planner.reset();
  EXPECT_EQ(copy.plan(request).path, expected.path);
  const Planner other(Grid(5, 5));
  copy = other;
  EXPECT_EQ(copy.grid().width(), 5);
}

TEST(Planner, ATokenInterrupts) {
  FarApart far;
  std::stop_source source;
  far.request.stop.token = source.get_token();
  Params params = quick("fan2004");
  params.iterations = 1000000;
  const Result result = far.plan(params, {.observer = [&](const GridProgress& p) {
                                   if (p.iteration == 4) source.request_stop();
                                 }});
  EXPECT_EQ(result.status, Status::interrupted);
  EXPECT_EQ(result.curves.iterations, 5);
  EXPECT_FALSE(result.path.empty());
}

TEST(Planner, ZeroIterationsEndWithoutAPath) {
  const Planner planner(blobs());
  Params params = quick("fan2004");
  params.iterations = 0;
  const Result result = planner.plan(far_apart(planner), params);
  EXPECT_EQ(result.status, Status::no_path);
  EXPECT_TRUE(result.curves.best.empty());
}

TEST(Planner, GapsThatAColonyCannotCertifyAreRefused) {
  FarApart far;
  far.request.target_gap = 0.01;
  EXPECT_THROW(far.plan(quick("fan2004")), Error);
  EXPECT_THROW(far.plan(quick("grid-ga")), Error);
  EXPECT_EQ(far.plan().status, Status::solved);
}

TEST(Planner, FaultsSayWhichEndAndWhy) {
  const Grid grid = with_blocked(5, 3, {{2, 0}, {2, 1}, {2, 2}});
  const Planner planner(grid);
  const auto asked = [&](Cell start, Cell goal) {
    return planner.plan({.start = start, .goal = goal});
  };
  EXPECT_EQ(asked({0, 0}, {1, 1}).fault, Fault::none);
  EXPECT_EQ(asked({2, 1}, {0, 0}).fault, Fault::start_blocked);
  EXPECT_EQ(asked({2, 1}, {0, 0}).nearest_free, (Cell{1, 1}));
  EXPECT_EQ(asked({-1, 1}, {0, 0}).fault, Fault::start_outside);
  EXPECT_EQ(asked({0, 0}, {2, 2}).fault, Fault::goal_blocked);
  EXPECT_EQ(asked({0, 0}, {5, 2}).fault, Fault::goal_outside);
  EXPECT_EQ(asked({0, 0}, {4, 2}).fault, Fault::disconnected);
  EXPECT_EQ(to_string(Fault::disconnected), "disconnected");
}

TEST(Planner, OnePlannerServesManyThreads) {
  const FarApart far;
  Params params = quick("fan2004");
  params.threads = 1;
  params.iterations = 4;
  const Result expected = far.plan(params);
  std::vector<Result> results(4);
  {
    std::vector<std::jthread> threads;
    for (Result& result : results) {
      threads.emplace_back([&] { result = far.plan(params); });
    }
  }
  for (const Result& result : results) expect_same(result, expected);
}

TEST(Planner, EditsMakeANewVersionAndLeaveTheOldOne) {
  const Grid grid = walled(600, 300, {{300, 0, 1, 300}});
  const Planner closed(grid);
  const Planner::Edit door{{300, 150}, false};
  const Planner open = *closed.edited({&door, 1});
  const Cell a{10, 10}, b{590, 290};
  EXPECT_FALSE(closed.connected(a, b));
  EXPECT_TRUE(open.connected(a, b));
  const Planner::Edit shut{{300, 150}, true};
  EXPECT_FALSE(open.edited({&shut, 1})->connected(a, b));
  EXPECT_EQ(open.edited({&shut, 1})->grid(), closed.grid());
  const Planner::Edit outside{{600, 0}, true};
  EXPECT_THROW((void)open.edited({&outside, 1}), Error);
}

TEST(Planner, ParametersOutOfRangeThrow) {
  const Planner planner(Grid(5, 5));
  Params params;
  params.ants = 0;
  EXPECT_THROW((void)planner.plan({.start = {0, 0}, .goal = {1, 1}}, params), Error);
}

}  // namespace
}  // namespace lasius
