#include "core/colony/walk_cutter.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "core/grid/move_rule.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/loop/same_result.h"
#include "tests/oracle/relaxed_walks.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

using Moves = std::vector<std::uint8_t>;

/// A random walk by the moves of a neighbourhood.
Moves random_tour(const Grid& grid, Corners corners, const kernels::Moves& moves, Cell start,
                  int steps, std::mt19937& random) {
  Moves tour;
  if (grid.blocked(start)) return tour;
  Cell c = start;
  for (int i = 0; i < steps; ++i) {
    const int k = random_in(0, moves.count - 1, random);
    if (!move_exists(grid, corners, c, moves[k])) continue;
    tour.push_back(static_cast<std::uint8_t>(k));
    c = c + moves[k].to;
  }
  return tour;
}

Cell end_of(const kernels::Moves& moves, Cell start, const Moves& tour) {
  for (const int k : tour) start = start + moves[k].to;
  return start;
}

double length_of(const kernels::Moves& moves, const Moves& tour) {
  double length = 0;
  for (const int k : tour) length += moves[k].length;
  return length;
}

/// Over the cells of the tour.
double shortest_within(const Grid& grid, Corners corners, Neighbours neighbours, Cell start,
                       const Moves& tour) {
  const kernels::Moves moves = moves_of(neighbours);
  Grid entered(grid.width(), grid.height());
  entered.set_blocked(start);
  Cell end = start;
  for (const int k : tour) {
    end = end + moves[k].to;
    entered.set_blocked(end);
  }
  const auto cost = [&](Cell c, oracle::Step step) {
    return entered.blocked({c.x + step.dx, c.y + step.dy})
               ? oracle::move_length(c, step)
               : std::numeric_limits<double>::infinity();
  };
  return oracle::relaxed_walks(grid, start, neighbours, corners,
                               cost)[end.y * grid.width() + end.x];
}

Moves cut(WalkCutter& cutter, const Grid& grid, Corners corners, const kernels::Moves& moves,
          Cell start, const Moves& tour) {
  GrowingArray<std::uint8_t> way;
  const auto count = cutter.cut(grid, corners, moves, start, tour, {}, {}, way);
  return {way.data(), way.data() + count};
}

TEST(WalkCutter, TheShortestWayOverTheTourByHand) {
  // Right, down, left, down, right twice: the step to the left goes.
  const Grid grid(8, 8);
  const kernels::Moves moves = moves_of(Neighbours::four);
  const auto by = [&](int dx, int dy) {
    for (int k = 0; k < moves.count; ++k) {
      if (moves[k].to.dx == dx && moves[k].to.dy == dy) return static_cast<std::uint8_t>(k);
    }
    return std::uint8_t{0xff};
  };
  const std::uint8_t right = by(1, 0), left = by(-1, 0), down = by(0, 1);
  WalkCutter cutter;
  EXPECT_EQ(
      cut(cutter, grid, Corners::forbid, moves, {1, 1}, {right, down, left, down, right, right})
          .size(),
      4u);
  EXPECT_EQ(cut(cutter, grid, Corners::forbid, moves, {1, 1}, {}), Moves{});
  // Down, right twice, up: two steps where the cell between was entered, too.
  const Moves around{down, right, right, by(0, -1)};
  const std::vector<kernels::PackedCell> more{kernels::pack(2, 1)};
  GrowingArray<std::uint8_t> way;
  EXPECT_EQ(cutter.cut(grid, Corners::forbid, moves, {1, 1}, around, {}, {}, way), 4);
  EXPECT_EQ(cutter.cut(grid, Corners::forbid, moves, {1, 1}, around, more, {}, way), 2);
}

TEST(WalkCutter, IsTheShortestForEveryNeighbourhoodAndRule) {
  std::mt19937 random(5);
  WalkCutter cutter;
  int shorter = 0;
  for (int n = 0; n < 6; ++n) {
    for (const Corners corners : {Corners::forbid, Corners::one_side, Corners::allow}) {
      const auto neighbours = static_cast<Neighbours>(n);
      const kernels::Moves moves = moves_of(neighbours);
      for (int i = 0; i < 12; ++i) {
        const Grid grid = random_grid(40, 30, 25, random);
        const Cell start = random_cell(grid, random);
        const Moves tour = random_tour(grid, corners, moves, start, 200, random);
        const Moves way = cut(cutter, grid, corners, moves, start, tour);
        ASSERT_EQ(end_of(moves, start, way), end_of(moves, start, tour));
        Cell c = start;
        for (const int k : way) {
          ASSERT_TRUE(move_exists(grid, corners, c, moves[k]));
          c = c + moves[k].to;
        }
        EXPECT_NEAR(length_of(moves, way), shortest_within(grid, corners, neighbours, start, tour),
                    1e-9);
        shorter += way.size() < tour.size();
      }
    }
  }
  EXPECT_GT(shorter, 100);
}

TEST(WalkCutter, AStopLeavesNoWay) {
  const Grid grid(300, 300);
  const kernels::Moves moves = moves_of(Neighbours::eight);
  std::mt19937 random(3);
  const Moves tour = random_tour(grid, Corners::forbid, moves, {150, 150}, 100000, random);
  GrowingArray<std::uint8_t> way;
  EXPECT_EQ(WalkCutter().cut(grid, Corners::forbid, moves, {150, 150}, tour, {}, fired(), way), -1);
}

// Of every family: the mean stays that of raw tours, the best is that of cut ones.
TEST(WalkCut, TheBestIsACutTourForAnyNumberOfThreads) {
  std::mt19937 random(8);
  const Planner planner(random_grid(60, 60, 20, random));
  const Cell start = planner.nearest_free({1, 1}).value();
  const Cell goal = planner.nearest_free({58, 58}).value();
  for (const char* name : {"as", "eas", "ras", "mmas", "acs", "fan2004"}) {
    Params params(name);
    params.iterations = 10;
    params.polish = Polish::none;
    params.straight_deposit = StraightDeposit::none;
    params.threads = 1;
    params.walk_cut = WalkCut::none;
    const Result raw = planner.plan({.start = start, .goal = goal}, params);
    params.walk_cut = WalkCut::own_cells;
    const Result one = planner.plan({.start = start, .goal = goal}, params);
    ASSERT_FALSE(one.path.empty()) << name;
    EXPECT_EQ(one.curves.mean.front(), raw.curves.mean.front()) << name;  // nothing is learned yet
    EXPECT_LT(one.curves.best.front(), raw.curves.best.front()) << name;
    EXPECT_EQ(one.curves.raw_best.front(), raw.curves.cut_best.front()) << name;
    EXPECT_EQ(raw.curves.cut_mean, raw.curves.mean) << name;
    EXPECT_EQ(one.curves.steps.front(), raw.curves.steps.front()) << name;
    EXPECT_LE(one.curves.best.front(), one.curves.cut_best.front() * (1 + 1e-12)) << name;
    EXPECT_GE(one.curves.cut_mean.front(), one.curves.cut_best.front()) << name;
    params.walk_cut = WalkCut::entered_cells;
    const Result entered = planner.plan({.start = start, .goal = goal}, params);
    if (params.neighbours == Neighbours::eight) {  // with 4 the first ants stepped back in vain
      EXPECT_LT(entered.curves.cut_mean.front(), one.curves.cut_mean.front()) << name;
    }
    params.walk_cut = WalkCut::own_cells;
    for (const int threads : {2, 5}) {
      params.threads = threads;
      SCOPED_TRACE(name);
      expect_same(planner.plan({.start = start, .goal = goal}, params), one);
    }
  }
}

}  // namespace
}  // namespace lasius
