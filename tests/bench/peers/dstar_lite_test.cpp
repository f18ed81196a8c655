#include "bench/peers/dstar_lite.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lasius/path/shortest_walk.h"
#include "tests/worlds/changing_world.h"

namespace lasius::peers {
namespace {

double walk(const Grid& grid, Cell from, Cell to) {
  return shortest_walk(grid, from, to, Neighbours::eight)
      .value_or(std::numeric_limits<double>::infinity());
}

/// Whole costs are a little off.
void expect_equal(double found, double length, std::uint64_t seed) {
  if (std::isinf(length)) {
    EXPECT_EQ(found, length) << "seed " << seed;
  } else {
    EXPECT_NEAR(found, length, 2e-5 * length) << "seed " << seed;
  }
}

TEST(DStarLite, IsAsShortAsAStarAfterEveryEditAndMove) {
  int moves = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Draw draw(seed);
    Grid grid = draw_map(draw, 10 + draw.below(30), 10 + draw.below(30));
    const Cell goal = draw_free(draw, grid);
    Cell robot = draw_free(draw, grid);
    DStarLite search(grid, robot, goal);
    expect_equal(search.plan(robot), walk(grid, robot, goal), seed);
    for (int edit = 0; edit < 40; ++edit) {
      std::vector<Cell> cells;
      const bool blocked = draw.one_in(2);
      for (int i = draw.below(12); i >= 0; --i) {
        const Cell c{draw.below(grid.width()), draw.below(grid.height())};
        if (c == robot || c == goal || grid.blocked(c) == blocked) continue;
        grid.set_blocked(c, blocked);
        cells.push_back(c);
      }
      search.observe(cells, blocked);
      const double length = search.plan(robot);
      expect_equal(length, walk(grid, robot, goal), seed);
      if (std::isfinite(length)) {
        robot = search.next();
        ++moves;
      }
    }
  }
  EXPECT_GT(moves, 500);
}

TEST(DStarLite, WalksTheShortestWay) {
  const Grid grid(20, 8);
  Cell robot{1, 1};
  DStarLite search(grid, robot, {15, 6});
  double travelled = 0;
  for (int i = 0; i < 14; ++i) {
    EXPECT_TRUE(std::isfinite(search.plan(robot)));
    const Cell to = search.next();
    travelled += std::hypot(to.x - robot.x, to.y - robot.y);
    robot = to;
  }
  EXPECT_EQ(robot, (Cell{15, 6}));
  EXPECT_NEAR(travelled, 9 + 5 * std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace lasius::peers
