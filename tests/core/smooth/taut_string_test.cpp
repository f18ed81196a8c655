#include "core/smooth/taut_string.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/smooth/loop_cutter.h"
#include "core/smooth/straighten.h"
#include "lasius/base/error.h"
#include "lasius/path/path.h"
#include "lasius/path/smooth.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/base/refusal.h"
#include "tests/core/grid/centres.h"
#include "tests/measures/count_allocations.h"
#include "tests/oracle/plane_rule.h"
#include "tests/oracle/visibility_graph.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

using Path = std::vector<Point>;

// The homotopy class of a path: the lines x = c + 0.25 are cut by the blocked cells into gaps, all
// blocked cells reach one of the lines, and so the gaps that a path crosses in turn, crossings
// taken back at once left out, name its class. No vertex is on a line.
using Gap = std::pair<int, int>;  // column, first row
std::vector<Gap> homotopy_class(const Grid& grid, const Path& path) {
  std::vector<Gap> word;
  const auto cross = [&](int column, double y) {
    int row = static_cast<int>(std::floor(y));
    if (grid.blocked({column, row}) && y == row) --row;
    while (grid.free({column, row - 1})) --row;
    const Gap gap{column, row};
    if (!word.empty() && word.back() == gap) {
      word.pop_back();
    } else {
      word.push_back(gap);
    }
  };
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point a = path[i - 1];
    const Point b = path[i];
    const auto y_at = [&](double x) { return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x); };
    const int from = static_cast<int>(std::ceil(a.x - 0.25));  // first line right of a
    const int to = static_cast<int>(std::ceil(b.x - 0.25));
    for (int c = from; c < to; ++c) cross(c, y_at(c + 0.25));
    for (int c = from - 1; c >= to; --c) cross(c, y_at(c + 0.25));
  }
  return word;
}

// True when some blocked cell touches v from inside the angle a, v, b, so that v cannot be cut.
bool taut_at(const Grid& grid, Point a, Point v, Point b) {
  if (v.x != std::floor(v.x) || v.y != std::floor(v.y)) return false;
  const auto cross = [](Point p, Point q, Point r) {
    return (q.x - p.x) * (r.y - q.y) - (q.y - p.y) * (r.x - q.x);
  };
  for (const double dy : {-0.5, 0.5}) {
    for (const double dx : {-0.5, 0.5}) {
      const Point c{v.x + dx, v.y + dy};
      if (grid.free({static_cast<int>(std::floor(c.x)), static_cast<int>(std::floor(c.y))})) {
        continue;
      }
      if (cross(a, v, c) * cross(a, v, b) > 0 && cross(v, b, c) * cross(a, v, b) > 0) return true;
    }
  }
  return false;
}

void expect_taut(const Grid& grid, const Path& path, const Path& taut) {
  ASSERT_EQ(taut.front(), path.front());
  ASSERT_EQ(taut.back(), path.back());
  ASSERT_EQ(path_fault(grid, taut), std::nullopt);
  ASSERT_TRUE(rule::Checker(grid).obeys(taut));
  ASSERT_LE(path_length(taut), path_length(path) * (1 + 1e-12));
  for (std::size_t i = 1; i + 1 < taut.size(); ++i) {
    ASSERT_TRUE(taut_at(grid, taut[i - 1], taut[i], taut[i + 1]));
  }
  ASSERT_EQ(homotopy_class(grid, taut), homotopy_class(grid, path));
  ASSERT_EQ(pull_taut(grid, taut), taut);
}

TEST(Tauten, BendsRoundTheCornersOfABlock) {
  const Grid grid = drawn({".....", ".###.", "....."});
  EXPECT_EQ(pull_taut(grid, Path{{0.5, 1.5}, {0.5, 0.5}, {4.5, 0.5}, {4.5, 1.5}}),
            (Path{{0.5, 1.5}, {1, 1}, {4, 1}, {4.5, 1.5}}));
  EXPECT_EQ(pull_taut(grid, Path{{0.5, 1.5}, {0.5, 0.5}, {0.5, 2.5}, {4.5, 2.5}, {4.5, 1.5}}),
            (Path{{0.5, 1.5}, {1, 2}, {4, 2}, {4.5, 1.5}}));
  EXPECT_EQ(pull_taut(grid, Path{{0.5, 0.5}, {2.5, 0.5}, {4.5, 0.5}}),
            (Path{{0.5, 0.5}, {4.5, 0.5}}));
  EXPECT_EQ(pull_taut(grid, Path{{0.5, 0.5}, {4.5, 0.5}, {2.5, 0.5}}),
            (Path{{0.5, 0.5}, {2.5, 0.5}}));
  EXPECT_EQ(pull_taut(grid, Path{{0.5, 0.5}, {4.5, 0.5}, {0.5, 0.5}}), (Path{{0.5, 0.5}}));
  EXPECT_EQ(pull_taut(grid, Path{{0.5, 0.5}}), (Path{{0.5, 0.5}}));
}

TEST(Tauten, GoesAllTheWayRoundABlockAndBack) {
  const Grid grid = drawn({"...", ".#.", "..."});
  // A loop keeps hold of the block.
  const Path loop{{0.5, 0.5}, {2.5, 0.5}, {2.5, 2.5}, {0.5, 2.5}, {0.5, 0.5}};
  EXPECT_EQ(pull_taut(grid, loop), (Path{{0.5, 0.5}, {2, 1}, {2, 2}, {1, 2}, {0.5, 0.5}}));
}

TEST(Tauten, SlidesAlongEdgesOnTheOuterSide) {
  // The corners above a - b are touched from outside and hold nothing.
  const Grid grid = drawn({"##...", ".....", "....#", "....."});
  EXPECT_EQ(pull_taut(grid, Path{{0, 1}, {2, 1}, {3.5, 2.5}, {3.5, 3.5}}),
            (Path{{0, 1}, {3.5, 3.5}}));
  EXPECT_EQ(pull_taut(grid, Path{{0, 1}, {2, 1}, {2.5, 0.5}}), (Path{{0, 1}, {2, 1}, {2.5, 0.5}}));
}

TEST(Tauten, RefusesAPathThatIsNotValid) {
  const Grid grid = drawn({".#."});
  expect_says(refusal([&] {
                pull_taut(grid, Path{{0.5, 0.5}, {2.5, 0.5}});
              }),
              "enters the blocked cell (1, 0)");
  EXPECT_THROW(pull_taut(grid, Path{}), Error);
  EXPECT_THROW(pull_taut(grid, Path{{0.25, 0.5}, {0.5, 0.5}}), Error);
}

TEST(Tauten, KeepsSqueezesWhenTheyAreAllowed) {
  const Grid grid = drawn({"..#", ".#.", "..."});
  const Path through{{0.5, 0.5}, {1.5, 0.5}, {2.5, 1.5}, {2.5, 2.5}};
  EXPECT_THROW(pull_taut(grid, through), Error);
  EXPECT_EQ(pull_taut(grid, through, Corners::allow), (Path{{0.5, 0.5}, {2, 1}, {2.5, 2.5}}));
}

TEST(Tauten, IsTheShortestOfItsClassOnRandomWalks) {
  std::mt19937 random(1);
  Straightener straightener;
  LoopCutter cutter;
  int best = 0;
  int other = 0;
  int bends = 0;
  for (int round = 0; round < 10000; ++round) {
    const Grid grid =
        random_grid(random_in(2, 40, random), random_in(2, 30, random), (round % 8) * 6, random);
    Walk walk =
        random_walk(grid, random_in(0, 300, random), round % 2 == 0, Corners::forbid, random);
    if (walk.empty()) continue;
    if (round % 3 != 0) {
      const auto cut = cutter.cut(grid, walk, true);
      walk.assign(cut.begin(), cut.end());
    }
    Path path = centres(walk);
    if (round % 3 == 2) {
      straightener.run(grid, walk);
      path = centres(straightener.vertices());
    }
    const Path taut = pull_taut(grid, path);
    ASSERT_NO_FATAL_FAILURE(expect_taut(grid, path, taut));
    bends += static_cast<int>(taut.size()) - 2;
    const auto optimum = oracle::VisibilityGraph(grid).shortest(walk.front(), walk.back());
    ASSERT_TRUE(optimum.has_value());
    ASSERT_GE(path_length(taut), optimum->length * (1 - 1e-12));
    if (homotopy_class(grid, taut) == homotopy_class(grid, optimum->path)) {
      ASSERT_NEAR(path_length(taut), optimum->length, 1e-9);
      ++best;
    } else {
      ++other;
    }
  }
  EXPECT_GT(best, 800);
  EXPECT_GT(other, 500);
  EXPECT_GT(bends, 5000);
}

// Vertices anywhere on the half-cell lattice, corners and edges of blocked cells among them.
TEST(Tauten, TakesAnyValidPolyline) {
  std::mt19937 random(2);
  int pulled = 0;
  for (int round = 0; round < 30000; ++round) {
    const Grid grid =
        random_grid(random_in(2, 8, random), random_in(2, 8, random), (round % 6) * 8, random);
    const Cell start = random_cell(grid, random);
    if (grid.blocked(start)) continue;
    Path path{centre(start)};
    for (int i = 0; i < 12; ++i) {
      const double x = std::clamp(path.back().x + random_in(-6, 6, random) / 2.0, 0.0,
                                  static_cast<double>(grid.width()));
      const double y = std::clamp(path.back().y + random_in(-6, 6, random) / 2.0, 0.0,
                                  static_cast<double>(grid.height()));
      path.push_back({x, y});
      if (path_fault(grid, path)) path.pop_back();
    }
    const auto at_centre = [](Point p) { return p.x != std::floor(p.x) && p.y != std::floor(p.y); };
    while (!at_centre(path.back())) path.pop_back();
    if (path.size() < 3) continue;
    ++pulled;
    ASSERT_NO_FATAL_FAILURE(expect_taut(grid, path, pull_taut(grid, path)));
  }
  EXPECT_GT(pulled, 4000);
}

TEST(Tauten, KeepsRandomSqueezes) {
  std::mt19937 random(4);
  int squeezes = 0;
  for (int round = 0; round < 1000; ++round) {
    const Grid grid = random_grid(random_in(2, 40, random), random_in(2, 30, random),
                                  20 + (round % 4) * 6, random);
    const Walk walk = random_walk(grid, random_in(0, 100, random), true, Corners::allow, random);
    if (walk.empty()) continue;
    const Path path = centres(walk);
    const Path taut = pull_taut(grid, path, Corners::allow);
    ASSERT_EQ(path_fault(grid, taut, Corners::allow), std::nullopt);
    ASSERT_LE(path_length(taut), path_length(path) * (1 + 1e-12));
    ASSERT_EQ(homotopy_class(grid, taut), homotopy_class(grid, path));
    ASSERT_EQ(pull_taut(grid, taut, Corners::allow), taut);
    squeezes += path_fault(grid, taut).has_value();
  }
  EXPECT_GT(squeezes, 200);
}

TEST(Tauten, HoldsAtTheLargestSide) {
  constexpr int kSide = Grid::kMaxSide;
  const Grid grid =
      with_blocked(kSide, kSide, {{kSide / 2, kSide / 2}, {kSide / 2 + 1, kSide / 2 - 1}});
  const Path path{{0.5, 0.5}, {kSide - 0.5, 0.5}, {kSide - 0.5, kSide - 0.5}};
  const Path taut = pull_taut(grid, path);
  EXPECT_EQ(taut, (Path{path.front(), {kSide / 2 + 2.0, kSide / 2 - 1.0}, {path.back()}}));
  EXPECT_EQ(pull_taut(grid, taut), taut);
}

TEST(TautString, AllocatesNothingTheSecondTime) {
  std::mt19937 random(3);
  const Grid grid = random_grid(300, 200, 10, random);
  const Walk walk = long_walk(grid, random);
  TautString taut;
  EXPECT_EQ(allocations_of_the_second([&] { taut.run(grid, walk); }), 0);
  EXPECT_LT(path_length(taut.path()), path_length(centres(walk)));
}

TEST(TautString, PollsInsideATriangleAndReturnsAValidPathWhenStopped) {
  // One triangle of 32768 rows of up to 512 words, empty but for its far corners.
  constexpr int kSide = Grid::kMaxSide;
  const Grid grid = with_blocked(kSide, kSide, {{kSide - 2, 1}});
  const Walk corner{{0, 0}, {kSide - 1, 0}, {kSide - 1, kSide - 1}};
  const CountingTime counted(1 << 30);
  TautString taut;
  taut.run(grid, corner, Corners::forbid, counted.is_up());
  EXPECT_EQ(taut.path().size(), 3u);
  EXPECT_EQ(taut.path()[1], (Point{kSide - 1.0, 1.0}));
  EXPECT_GE(counted.polls(), 100);  // half of 32768 x 512 words, 65536 between two polls: 128
  const CountingTime third(2);
  taut.run(grid, corner, Corners::forbid, third.is_up());
  EXPECT_EQ(third.polls(), 3);
  EXPECT_EQ(path_length(taut.path()), 2 * (kSide - 1));
}

}  // namespace
}  // namespace lasius
