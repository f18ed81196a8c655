#include "core/drive/path_walker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lasius/plan/planner.h"
#include "tests/worlds/changing_world.h"

namespace lasius {
namespace {

TEST(PathWalker, TouchesAsClosedSquaresDo) {
  const Point a{0.5, 0.5}, b{3.5, 0.5}, corner{2, 1};
  EXPECT_TRUE(touches(a, b, {0, 0}));
  EXPECT_TRUE(touches(a, b, {3, 0}));
  EXPECT_FALSE(touches(a, b, {4, 0}));
  EXPECT_FALSE(touches(a, b, {1, 1}));
  for (const Cell c : {Cell{1, 0}, Cell{2, 0}, Cell{1, 1}, Cell{2, 1}}) {
    EXPECT_TRUE(touches(corner, corner, c));
  }
  EXPECT_FALSE(touches(corner, corner, {0, 0}));
  EXPECT_TRUE(touches({0.5, 0.5}, {1.5, 1.5}, {1, 0}));   // at its corner
  EXPECT_FALSE(touches({0.5, 0.5}, {2.5, 1.5}, {0, 1}));  // past it
}

/// Walks a path to its end; the moves made.
std::vector<Cell> whole_walk(const Grid& grid, const std::vector<Point>& path, Cell start) {
  PathWalker walker;
  walker.begin(path);
  std::vector<Cell> all{start}, piece;
  for (;;) {
    walker.next(grid, Corners::forbid, all.back(), piece);
    if (piece.size() < 2) return all;
    all.insert(all.end(), piece.begin() + 1, piece.end());
  }
}

TEST(PathWalker, FollowsAStraightSegmentCellByCell) {
  const Grid grid(8, 4);
  EXPECT_EQ(whole_walk(grid, {{0.5, 1.5}, {4.5, 1.5}}, {0, 1}),
            std::vector<Cell>({{0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 1}}));
  EXPECT_EQ(whole_walk(grid, {{0.5, 0.5}, {3.5, 3.5}}, {0, 0}),
            std::vector<Cell>({{0, 0}, {1, 1}, {2, 2}, {3, 3}}));
}

TEST(PathWalker, ReachesTheEndOfShortestPathsOverCellsThatTheyTouch) {
  int walked = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Draw draw(seed);
    const Grid grid = draw_map(draw, 10 + draw.below(150), 10 + draw.below(150));
    const Cell start = draw_free(draw, grid), goal = draw_free(draw, grid);
    const Result plan = Planner(grid).plan({start, goal});
    if (plan.path.empty()) continue;
    const std::vector<Cell> walk = whole_walk(grid, plan.path, start);
    ASSERT_EQ(walk.back(), goal) << "seed " << seed;
    walked += walk.size() > 100 ? 1 : 0;
    std::size_t near = 0;  // the segment that was touched last: looked at first
    for (std::size_t i = 0; i < walk.size(); ++i) {
      bool touched = false;
      for (std::size_t k = 0; k + 1 < plan.path.size() && !touched; ++k) {
        const std::size_t s = (near + k) % (plan.path.size() - 1);
        touched = touches(plan.path[s], plan.path[s + 1], walk[i]);
        if (touched) near = s;
      }
      ASSERT_TRUE(touched || start == goal) << "seed " << seed;
      if (i == 0) continue;
      const Cell a = walk[i - 1], b = walk[i];
      ASSERT_LE(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)), 1) << "seed " << seed;
      ASSERT_TRUE(grid.free(b) && grid.free({a.x, b.y}) && grid.free({b.x, a.y}));
    }
  }
  EXPECT_GT(walked, 30);
}

TEST(PathWalker, KnowsWhatIsLeft) {
  PathWalker walker;
  walker.begin({{0.5, 0.5}, {99.5, 0.5}, {99.5, 9.5}});
  std::vector<Cell> piece;
  const Grid grid(100, 10);
  walker.next(grid, Corners::forbid, {0, 0}, piece);
  EXPECT_EQ(walker.vertices_after({40, 0}), 1u);
  EXPECT_TRUE(walker.touches_rest({0, 0}));
  EXPECT_FALSE(walker.touches_rest({0, 1}));
  while (piece.back() != Cell{99, 9}) walker.next(grid, Corners::forbid, piece.back(), piece);
  EXPECT_EQ(walker.vertices_after({99, 5}), 0u);
  EXPECT_TRUE(walker.touches_rest({99, 5}));
}

}  // namespace
}  // namespace lasius
