#include "lasius/path/shortest_walk.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/base/counting_time.h"
#include "tests/oracle/relaxed_walks.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

const double kSqrt2 = std::sqrt(2.0);

TEST(ShortestWalk, ByHand) {
  Grid grid(5, 5);
  const auto length = [&](Neighbours neighbours) {
    return shortest_walk(grid, {0, 0}, {4, 2}, neighbours).value();
  };
  EXPECT_EQ(length(Neighbours::four), 6);
  EXPECT_DOUBLE_EQ(length(Neighbours::eight), 2 + 2 * kSqrt2);
  EXPECT_DOUBLE_EQ(length(Neighbours::sixteen), 2 + 2 * kSqrt2);  // longer, no new direction
  EXPECT_DOUBLE_EQ(length(Neighbours::sixteen_knight), 2 * std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(length(Neighbours::twenty_four), 2 * std::sqrt(5.0));
  EXPECT_EQ(shortest_walk(grid, {3, 3}, {3, 3}, Neighbours::eight), 0);
}

TEST(ShortestWalk, CornersCloseDiagonals) {
  Grid grid(2, 2);
  const auto diagonal = [&](Corners corners) {
    return shortest_walk(grid, {0, 0}, {1, 1}, Neighbours::eight, corners);
  };
  grid.set_blocked({1, 0});
  EXPECT_EQ(diagonal(Corners::forbid), 2);
  EXPECT_EQ(diagonal(Corners::one_side), kSqrt2);
  grid.set_blocked({0, 1});
  EXPECT_EQ(diagonal(Corners::allow), kSqrt2);
  EXPECT_FALSE(diagonal(Corners::one_side));
}

TEST(ShortestWalk, NothingWhereThereIsNone) {
  const Grid grid = walled(5, 5, {{0, 1, 5, 1}});
  EXPECT_FALSE(shortest_walk(grid, {0, 0}, {4, 2}, Neighbours::eight, Corners::allow));
  EXPECT_FALSE(shortest_walk(grid, {0, 1}, {4, 2}, Neighbours::eight));
  EXPECT_FALSE(shortest_walk(grid, {0, 0}, {5, 0}, Neighbours::eight));
}

TEST(ShortestWalk, StopsWhenTold) {
  const Grid grid = walled(600, 600, {{300, 0, 1, 599}});
  EXPECT_TRUE(shortest_walk(grid, {0, 0}, {500, 3}, Neighbours::four));
  EXPECT_FALSE(shortest_walk(grid, {0, 0}, {500, 3}, Neighbours::four, Corners::forbid, fired()));
}

TEST(ShortestWalk, EqualsBellmanFordOnRandomGrids) {
  std::mt19937 random(20260111);
  int reachable = 0, unreachable = 0;
  for (int i = 0; i < 360; ++i) {
    const auto neighbours = static_cast<Neighbours>(i % 6);
    const auto corners = static_cast<Corners>(i / 6 % 3);
    const Grid grid = random_grid(random_in(2, 24, random), random_in(2, 24, random),
                                  random_in(5, 45, random), random);
    const Cell start = random_cell(grid, random), goal = random_cell(grid, random);
    if (grid.blocked(start) || grid.blocked(goal)) continue;
    const double expected =
        oracle::relaxed_walks(grid, start, neighbours, corners)[goal.y * grid.width() + goal.x];
    const auto length = shortest_walk(grid, start, goal, neighbours, corners);
    SCOPED_TRACE(i);
    ASSERT_EQ(length.has_value(), std::isfinite(expected));
    if (length) {
      EXPECT_NEAR(*length, expected, 1e-9);
    }
    ++(length ? reachable : unreachable);
  }
  EXPECT_GT(reachable, 100);
  EXPECT_GT(unreachable, 10);
}

}  // namespace
}  // namespace lasius
