#include "kernels/sight/sight.h"

#include <gtest/gtest.h>

#include "core/grid/grid_view.h"
#include "kernels/sight/sight_cone.h"
#include "lasius/path/path.h"
#include "tests/oracle/plane_rule.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

using kernels::HalfPoint;

bool obeys(const Grid& grid, HalfPoint a, HalfPoint b) {
  return rule::segment_obeys(grid, {a.x, a.y, b.x, b.y});
}
Point point(HalfPoint p) { return {p.x / 2.0, p.y / 2.0}; }

std::string where(const Grid& grid, HalfPoint a, HalfPoint b) {
  std::string text = std::to_string(a.x) + ',' + std::to_string(a.y) + " - " + std::to_string(b.x) +
                     ',' + std::to_string(b.y) + " (half cells) in\n";
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) text += grid.blocked({x, y}) ? '#' : '.';
    text += '\n';
  }
  return text;
}

TEST(Sight, KeepsTheRuleWorkedByHand) {
  const Grid grid = drawn({".....", ".##..", "..#..", ".#...", "....."});
  const auto map = view_of(grid);
  EXPECT_TRUE(kernels::sees(map, {1, 1}, {9, 1}));
  EXPECT_FALSE(kernels::sees(map, {1, 1}, {9, 9}));  // through (1, 1)
  EXPECT_TRUE(kernels::sees(map, {1, 1}, {1, 9}));
  EXPECT_TRUE(kernels::sees(map, {0, 2}, {10, 2}));  // slides along the top of two blocks
  EXPECT_TRUE(kernels::sees(map, {1, 3}, {3, 1}));   // touches the corner of (1, 1)
  EXPECT_FALSE(kernels::sees(map, {3, 5}, {5, 7}));  // squeezes between (2, 2) and (1, 3)
  EXPECT_FALSE(kernels::sees(map, {2, 4}, {6, 4}));  // between (1, 1), (2, 1) and (2, 2)
  EXPECT_TRUE(kernels::sees(map, {2, 4}, {4, 4}));   // under (1, 1), a free cell below
  EXPECT_FALSE(kernels::sees(map, {4, 2}, {4, 6}));  // between (1, 1) and (2, 1)
  EXPECT_FALSE(kernels::sees(map, {4, 4}, {4, 8}));  // changes sides between two blocks
  EXPECT_TRUE(kernels::sees(map, {0, 0}, {10, 0}));  // along the edge of the map
  EXPECT_TRUE(visible(grid, {0, 0}, {4, 0}));
  EXPECT_FALSE(visible(grid, {0, 0}, {1, 1}));
  EXPECT_FALSE(visible(grid, {0, 0}, {-1, 0}));
}

TEST(Sight, AgreesWithTheRuleOnAllPairsOfSmallGrids) {
  std::mt19937 random(1);
  std::int64_t seen = 0;
  for (int round = 0; round < 60; ++round) {
    const Grid grid =
        random_grid(random_in(1, 7, random), random_in(1, 7, random), 10 * (round % 7), random);
    const auto map = view_of(grid);
    const rule::Checker checker(grid);
    for (int i = 0; i < 4 * (grid.width() + 1) * (grid.height() + 1); ++i) {
      const int w = 2 * grid.width() + 1;
      const HalfPoint a{i % w, i / w};
      if (a.y > 2 * grid.height()) break;
      for (HalfPoint b{0, 0}; b.y <= 2 * grid.height(); ++b.y) {
        for (b.x = 0; b.x <= 2 * grid.width(); ++b.x) {
          const bool got = kernels::sees(map, a, b);
          seen += got;
          if (a == b) continue;
          ASSERT_EQ(got, obeys(grid, a, b)) << where(grid, a, b);
          const Point path[] = {point(a), point(b)};
          ASSERT_EQ(got, checker.obeys(path)) << where(grid, a, b);
        }
      }
    }
  }
  EXPECT_GT(seen, 100000);
}

TEST(Sight, AgreesWithTheRuleAcrossWords) {
  std::mt19937 random(2);
  int seen = 0;
  for (int round = 0; round < 300; ++round) {
    Grid grid(random_in(60, 300, random), random_in(1, 40, random));
    for (int i = random_in(0, 12, random); i > 0; --i) {
      grid.set_blocked(random_cell(grid, random));
    }
    const auto map = view_of(grid);
    for (int i = 0; i < 60; ++i) {
      const HalfPoint a{random_in(0, 2 * grid.width(), random),
                        random_in(0, 2 * grid.height(), random)};
      HalfPoint b{random_in(0, 2 * grid.width(), random), random_in(0, 2 * grid.height(), random)};
      if (i % 3 == 0) b.y = a.y;
      if (i % 5 == 0) b.x = a.x;
      if (a == b) continue;
      const bool got = kernels::sees(map, a, b);
      seen += got;
      ASSERT_EQ(got, obeys(grid, a, b)) << where(grid, a, b);
    }
  }
  EXPECT_GT(seen, 3000);
}

TEST(Sight, HoldsAtTheLargestSide) {
  Grid grid(Grid::kMaxSide, Grid::kMaxSide);
  const auto map = view_of(grid);
  const int far = 2 * Grid::kMaxSide;
  EXPECT_TRUE(kernels::sees(map, {1, 1}, {far - 1, far - 1}));
  EXPECT_TRUE(kernels::sees(map, {0, far}, {far, 0}));
  EXPECT_TRUE(kernels::sees(map, {1, 1}, {far - 1, 3}));
  EXPECT_TRUE(kernels::sees(map, {far - 1, 1}, {1, far - 1}));
  grid.set_blocked({16383, 16384});
  EXPECT_TRUE(kernels::sees(map, {1, 1}, {far - 1, far - 1}));  // touches its corners
  EXPECT_FALSE(kernels::sees(map, {0, far}, {far, 0}));
  grid.set_blocked({16384, 16383});
  EXPECT_FALSE(kernels::sees(map, {1, 1}, {far - 1, far - 1}));
  EXPECT_TRUE(kernels::sees(map, {1, 1}, {far - 1, 32767}));
  grid.set_blocked({24576, 12287});
  EXPECT_FALSE(kernels::sees(map, {1, 1}, {far - 1, 32767}));
}

// A walk that may be on any cell, until it is hidden from where it began.
TEST(SightCone, EqualsSightForEveryStepOfRandomWalks) {
  std::mt19937 random(3);
  kernels::SightCone cone;
  std::int64_t steps = 0;
  std::int64_t hidden = 0;
  for (int round = 0; round < 20000; ++round) {
    const Grid grid =
        random_grid(random_in(2, 90, random), random_in(2, 24, random), (round % 5) * 8, random);
    const auto map = view_of(grid);
    Cell at = random_cell(grid, random);
    if (grid.blocked(at)) continue;
    const Cell from = at;
    cone.start(map, at.x, at.y, 0, grid.width() - 1);
    // A drift makes walks that go far.
    const int drift_x = random_in(-1, 1, random);
    const int drift_y = random_in(-1, 1, random);
    const bool diagonal = round % 2 == 0;
    for (int i = 0; i < 200; ++i) {
      const bool drift = random() % 3 != 0;
      const int dx = drift ? drift_x : random_in(-1, 1, random);
      const int dy = drift && diagonal ? drift_y : random_in(-1, 1, random);
      if (!diagonal && dx != 0 && dy != 0) continue;
      const Cell next{at.x + dx, at.y + dy};
      if (grid.blocked(next)) continue;
      at = next;
      ++steps;
      const bool seen = kernels::sees_cell(map, from.x, from.y, at.x, at.y);
      ASSERT_EQ(cone.sees_next(at.x, at.y), seen)
          << where(grid, {2 * from.x + 1, 2 * from.y + 1}, {2 * at.x + 1, 2 * at.y + 1});
      hidden += !seen;
      if (!seen) break;
    }
  }
  EXPECT_GT(steps, 300000);
  EXPECT_GT(hidden, 3000);
}

}  // namespace
}  // namespace lasius
