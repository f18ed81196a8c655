#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "lasius/base/error.h"
#include "lasius/plan/batch.h"
#include "lasius/plan/planner.h"
#include "tests/core/loop/same_result.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

double apart(Cell a, Cell b) { return std::hypot(1.0 * a.x - b.x, 1.0 * a.y - b.y); }

/// Cell by cell: the nearest to `to` that is joined to `from`.
std::optional<Cell> nearest_of_all(const Planner& planner, Cell from, Cell to, Corners corners) {
  std::optional<Cell> best;
  const auto order = [&](Cell c) { return std::tuple(apart(c, to), c.y, c.x); };
  for (const Cell c : cells_of(planner.grid()))
    if (planner.connected(from, c, corners) && (!best || order(c) < order(*best))) best = c;
  return best;
}

TEST(GoalTolerance, TheNearestIsTheOneOfASearchThroughAllCells) {
  int found = 0, other = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    const int width = random_in(1, 150, random), height = random_in(1, 40, random);
    const Planner planner(random_grid(width, height, random_in(0, 60, random), random));
    for (int i = 0; i < 20; ++i) {
      const Cell from = random_cell(planner.grid(), random);
      const Cell to{random_in(-20, width + 20, random), random_in(-20, height + 20, random)};
      for (const Corners corners : {Corners::forbid, Corners::allow}) {
        const auto nearest = planner.nearest_reachable(to, from, corners);
        ASSERT_EQ(nearest, nearest_of_all(planner, from, to, corners)) << "seed " << seed;
        if (!nearest) continue;
        ++found;
        other += nearest != planner.nearest_free(to);
      }
    }
  }
  EXPECT_GT(found, 500);
  EXPECT_GT(other, 100);
}

TEST(GoalTolerance, OfAPointTheNearestCentreCounts) {
  int found = 0, of_another_cell = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    const int width = random_in(1, 12, random), height = random_in(1, 9, random);
    const Planner planner(random_grid(width, height, random_in(20, 70, random), random));
    const Cell from = random_cell(planner.grid(), random);
    if (planner.grid().blocked(from)) continue;
    for (int i = 0; i < 20; ++i) {
      const Point goal{random_in(-8, 4 * width + 8, random) / 4.0,
                       random_in(-8, 4 * height + 8, random) / 4.0};
      const Cell cell{static_cast<int>(std::floor(goal.x)), static_cast<int>(std::floor(goal.y))};
      Request request{.start = from, .goal_point = goal};
      if (planner.plan(request).status == Status::solved) continue;
      std::optional<std::tuple<double, int, int>> best;
      for (const Cell c : cells_of(planner.grid()))
        if (const std::tuple order(std::hypot(c.x + 0.5 - goal.x, c.y + 0.5 - goal.y), c.y, c.x);
            planner.connected(from, c) && (!best || order < *best))
          best = order;
      const auto [apart, y, x] = *best;
      request.goal_tolerance = apart * (1 + 1e-12);
      ASSERT_EQ(planner.plan(request).goal_reached, (Cell{x, y})) << seed << ", " << i;
      request.goal_tolerance = 0.999 * apart;
      ASSERT_EQ(planner.plan(request).goal_reached, std::nullopt) << seed << ", " << i;
      ++found;
      of_another_cell += planner.nearest_reachable(cell, from) != Cell{x, y};
    }
  }
  EXPECT_GT(found, 1000);
  EXPECT_GT(of_another_cell, 50);
}

/// A goal in a shelf that is shut, with a door on no side.
Grid shelf() {
  Grid grid = walled(20, 16, {{10, 5, 7, 7}});
  grid.fill({11, 6, 5, 5}, false);
  grid.set_blocked({12, 8});
  return grid;
}

class GoalToleranceOf : public testing::TestWithParam<const char*> {};

TEST_P(GoalToleranceOf, EndsAtTheNearestCellThatCanBeReached) {
  const Planner planner(shelf());
  const Params params = quick(GetParam());
  struct Case {
    Cell goal;
    double tolerance;
    std::optional<Cell> end;
  };
  const Case cases[] = {{{12, 8}, 3, Cell{9, 8}},  // blocked, the shelf's own cells are nearer
                        {{12, 8}, 2.999, std::nullopt},  // just too far
                        {{13, 7}, 4, Cell{13, 4}},       // free, but in the shelf: 3 away
                        {{13, 8}, 1e300, Cell{13, 4}},   // the upper of four
                        {{25, 8}, 6, Cell{19, 8}},       // outside
                        {{25, 8}, 5.9, std::nullopt},   {{3, 3}, 5, Cell{3, 3}},  // the goal itself
                        {{2, 2}, 5, Cell{2, 2}}};                                 // the start
  for (const auto& [goal, tolerance, end] : cases) {
    const Request plain{.start = {2, 2}, .goal = goal};
    Request request = plain;
    request.goal_tolerance = tolerance;
    const Result result = planner.plan(request, params), without = planner.plan(plain, params);
    EXPECT_EQ(result.goal_reached, end);
    EXPECT_EQ(without.goal_reached, std::nullopt);
    if (!end) {
      EXPECT_EQ(result.status, without.status);
      EXPECT_EQ(result.fault, without.fault);
      EXPECT_NE(result.error.find("from the goal, its tolerance"), std::string::npos);
      continue;
    }
    EXPECT_EQ(result.status, Status::solved) << result.error;
    ASSERT_FALSE(result.path.empty());
    EXPECT_EQ(result.path.back(), centre(*end));
    Result there = planner.plan({.start = {2, 2}, .goal = *end}, params);
    there.goal_reached = end;
    expect_same(result, there);
  }
}

INSTANTIATE_TEST_SUITE_P(Algorithms, GoalToleranceOf,
                         testing::Values("exact", "fan2004", "acs", "terminal-index", "grid-ga"),
                         by_algorithm);

TEST(GoalTolerance, ABadStartStaysBadAndABadToleranceIsRefused) {
  const Planner planner(shelf());
  const Result result = planner.plan({.start = {12, 8}, .goal = {2, 2}, .goal_tolerance = 9});
  EXPECT_EQ(result.fault, Fault::start_blocked);
  EXPECT_EQ(result.goal_reached, std::nullopt);
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const Request request{.start = {2, 2}, .goal = {3, 3}, .goal_tolerance = bad};
    EXPECT_THROW(planner.plan(request), Error);
    EXPECT_THROW(plan_batch(planner, std::span(&request, 1)), Error);
  }
}

TEST(NearestFree, TheAdviceCanBeFollowed) {
  const Planner planner(shelf());
  const auto goal = planner.plan({.start = {2, 2}, .goal = {12, 8}});
  EXPECT_EQ(goal.error,
            "goal (12, 8) is blocked; the nearest free cell that can be reached from the start is "
            "(9, 8); (12, 7) is nearer, but cannot be reached");
  EXPECT_EQ(goal.nearest_free, (Cell{12, 7}));
  EXPECT_EQ(goal.nearest_reachable, (Cell{9, 8}));
  EXPECT_EQ(planner.plan({.start = {12, 8}, .goal = {2, 2}}).error,
            "start (12, 8) is blocked; the nearest free cell from which the goal can be reached is "
            "(9, 8); (12, 7) is nearer, but does not lead there");
  EXPECT_EQ(planner.plan({.start = {2, 2}, .goal = {10, 8}}).error,
            "goal (10, 8) is blocked; the nearest free cell is (9, 8)");
  const auto both = planner.plan({.start = {12, 8}, .goal = {10, 8}});
  EXPECT_EQ(both.error, "start (12, 8) is blocked; the nearest free cell is (12, 7)");
  EXPECT_EQ(both.nearest_reachable, std::nullopt);
}

}  // namespace
}  // namespace lasius
