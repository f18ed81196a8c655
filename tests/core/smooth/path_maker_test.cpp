#include "core/smooth/path_maker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <random>
#include <vector>

#include "lasius/path/path.h"
#include "lasius/path/smooth.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/grid/centres.h"
#include "tests/oracle/visibility_graph.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

// A walk through these cells, straight along rows and columns.
Walk through(std::initializer_list<Cell> cells) {
  Walk walk;
  for (const Cell to : cells) {
    if (walk.empty()) walk.push_back(to);
    while (walk.back() != to) {
      const Cell at = walk.back();
      const int dx = (to.x > at.x) - (to.x < at.x);
      walk.push_back(dx != 0 ? Cell{at.x + dx, at.y} : Cell{at.x, at.y + (to.y > at.y ? 1 : -1)});
    }
  }
  return walk;
}

std::vector<Point> made(PathMaker& maker, const Grid& grid, const Walk& walk, Polish polish,
                        const StopCondition& stop = {}) {
  std::vector<Point> path;
  const auto way = maker.cut(grid, walk, false, Corners::forbid, stop);
  Params params("fan2004");
  params.polish = polish;
  maker.polish(grid, way, params, stop, path);
  return path;
}

std::vector<Point> made_locally(const Grid& grid, const Walk& walk, double window) {
  Params params("fan2004");
  params.polish = Polish::local;
  params.straight_window = window;
  std::vector<Point> path;
  PathMaker().polish(grid, walk, params, {}, path);
  return path;
}

// A walk that leaves the row of its ends by 7 cells over 10 of 30 columns.
TEST(LocalPolish, TheWindowSaysHowFarAStretchMayStray) {
  const Grid grid(40, 20);
  const Walk walk = through({{0, 5}, {10, 5}, {10, 12}, {20, 12}, {20, 5}, {30, 5}});
  const std::vector<Point> straight{{0.5, 5.5}, {30.5, 5.5}};
  EXPECT_EQ(made_locally(grid, walk, 8), straight);
  // Too narrow for the whole, and for what earlier passes leave: a bend stays.
  double before = 30;
  for (const double window : {1.0, 0.0}) {
    const double length = path_length(made_locally(grid, walk, window));
    EXPECT_GT(length, before) << window;
    before = length;
  }
  EXPECT_DOUBLE_EQ(before, 44);  // 0: nothing but what lies on one line
}

TEST(LocalPolish, AWideWindowIsGreedyStraightening) {
  std::mt19937 random(7);
  for (int i = 0; i < 40; ++i) {
    const Grid grid = random_grid(50, 40, 20, random);
    const Walk walk = random_walk(grid, 300, false, Corners::forbid, random);
    if (walk.size() < 2) continue;
    std::vector<Point> greedy;
    for (const Cell c : greedy_straighten(grid, walk)) greedy.push_back(centre(c));
    EXPECT_EQ(made_locally(grid, walk, 1000), greedy);
  }
}

// A wall between start and goal; the walk looks round its near end, but goes round the far one.
class Wall : public testing::Test {
 protected:
  const Grid grid_ = drawn({".......", "...#...", "...#...", "...#...", "...#...", "...#...",
                            "...#...", "...#...", "...#...", "......."});
  const Walk walk_ = through({{2, 2}, {2, 0}, {1, 0}, {1, 9}, {5, 9}, {5, 1}, {4, 1}, {4, 2}});
  PathMaker maker_;
};

TEST_F(Wall, TheWalkIsCutShort) {
  const std::vector<Point> over{{2.5, 2.5}, {2.5, 1.5}, {3.5, 0.5}, {4.5, 1.5}, {4.5, 2.5}};
  EXPECT_EQ(made(maker_, grid_, walk_, Polish::straight), over);
  EXPECT_EQ(std::ranges::count(maker_.raster(), Cell{3, 0}), 1);
  const std::vector<Point> taut{{2.5, 2.5}, {3, 1}, {4, 1}, {4.5, 2.5}};
  EXPECT_EQ(made(maker_, grid_, walk_, Polish::taut), taut);
  EXPECT_EQ(std::ranges::count(maker_.raster(), Cell{3, 0}), 1);
}

TEST_F(Wall, NotWhereTheWalkHasNotBeen) {
  const Walk walk = through({{2, 2}, {1, 2}, {1, 9}, {5, 9}, {5, 2}, {4, 2}});
  for (const Polish polish : {Polish::straight, Polish::taut}) {
    const auto path = made(maker_, grid_, walk, polish);
    EXPECT_TRUE(std::ranges::any_of(path, [](Point p) { return p.y > 8; }));
  }
}

TEST_F(Wall, NotWhenStopped) {
  const CountingTime counted(1 << 30);
  made(maker_, grid_, walk_, Polish::straight, counted.is_up());
  for (int looks = 0; looks < counted.polls(); ++looks) {
    const CountingTime up(looks);
    const auto path = made(maker_, grid_, walk_, Polish::straight, up.is_up());
    EXPECT_EQ(path.front(), centre(walk_.front()));
    EXPECT_EQ(path.back(), centre(walk_.back()));
    EXPECT_FALSE(path_fault(grid_, path).has_value());
  }
}

// Whatever the walk: a valid path, and no longer one than without shortcuts.
TEST(PathMaker, IsNeverLongerThanWithoutShortcuts) {
  std::mt19937 random(8);
  PathMaker maker;
  LoopCutter cutter;
  int shorter = 0;
  for (int i = 0; i < 4000; ++i) {
    const Grid grid =
        random_grid(random_in(2, 60, random), random_in(2, 40, random), (i % 6) * 7, random);
    const Walk walk = random_walk(grid, random_in(0, 600, random), false, Corners::forbid, random);
    if (walk.empty()) continue;
    const auto cut = cutter.cut(grid, walk);
    const Walk way(cut.begin(), cut.end());
    const double tight = path_length(centres(straighten(grid, way)));
    const double taut = path_length(pull_taut(grid, centres(greedy_straighten(grid, way))));
    const double optimum =
        oracle::VisibilityGraph(grid).shortest(walk.front(), walk.back())->length;
    for (const Polish polish : {Polish::straight, Polish::taut}) {
      const auto path = made(maker, grid, walk, polish);
      ASSERT_FALSE(path_fault(grid, path).has_value());
      ASSERT_EQ(path.front(), centre(walk.front()));
      ASSERT_EQ(path.back(), centre(walk.back()));
      const double length = path_length(path);
      const double without = polish == Polish::straight ? tight : taut;
      EXPECT_LE(length, without * (1 + 1e-12));
      EXPECT_GE(length, optimum * (1 - 1e-9));
      shorter += length < without * 0.99;
      for (const Cell c : maker.raster()) ASSERT_TRUE(grid.free(c));
    }
  }
  EXPECT_GT(shorter, 50);
}

}  // namespace
}  // namespace lasius
