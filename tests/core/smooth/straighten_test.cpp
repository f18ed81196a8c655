#include "core/smooth/straighten.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/smooth/loop_cutter.h"
#include "lasius/base/error.h"
#include "lasius/path/path.h"
#include "lasius/path/smooth.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/grid/centres.h"
#include "tests/measures/count_allocations.h"
#include "tests/oracle/plane_rule.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

double length_of(std::span<const Cell> cells) { return path_length(centres(cells)); }

// Greedy line of sight by the slow way.
Walk pulled(const Grid& grid, const Walk& walk) {
  Walk polyline{walk[0]};
  for (std::size_t anchor = 0, next = 1; next < walk.size(); anchor = next - 1) {
    while (next < walk.size() && visible(grid, walk[anchor], walk[next])) ++next;
    if (next == anchor + 1) ++next;
    if (walk[next - 1] != polyline.back()) polyline.push_back(walk[next - 1]);
  }
  return polyline;
}

bool one_piece(const Grid& grid, std::span<const Cell> cells, bool squeezes_kept) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (grid.blocked(cells[i])) return false;
    if (i == 0) continue;
    const Cell a = cells[i - 1];
    const Cell b = cells[i];
    const int step = std::abs(a.x - b.x) + std::abs(a.y - b.y);
    const bool squeeze = squeezes_kept && std::abs(a.x - b.x) == 1 && std::abs(a.y - b.y) == 1 &&
                         grid.blocked({a.x, b.y}) && grid.blocked({b.x, a.y});
    if (step != 1 && !squeeze) return false;
  }
  return true;
}

// True when the cells pass all vertices in order.
bool passes(std::span<const Cell> cells, std::span<const Cell> vertices) {
  auto at = cells.begin();
  for (const Cell v : vertices) {
    at = std::find(at, cells.end(), v);
    if (at == cells.end()) return false;
  }
  return true;
}

TEST(Straighten, PullsAStaircaseIntoOneSegment) {
  const Grid grid(8, 8);
  EXPECT_EQ(greedy_straighten(grid, Walk{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {3, 2}}),
            (Walk{{0, 0}, {3, 2}}));
  EXPECT_EQ(greedy_straighten(grid, Walk{{0, 0}, {1, 0}, {2, 0}}), (Walk{{0, 0}, {2, 0}}));
  EXPECT_EQ(greedy_straighten(grid, Walk{{4, 4}, {4, 4}}), (Walk{{4, 4}}));
  EXPECT_EQ(greedy_straighten(grid, Walk{{4, 4}, {4, 5}, {4, 4}}), (Walk{{4, 4}}));
  EXPECT_EQ(greedy_straighten(grid, Walk{}), Walk{});
}

TEST(Straighten, GoesRoundABlock) {
  const Grid grid = drawn({".....", ".###.", "....."});
  // Forth: (1, 0) is hidden from (0, 2), and (4, 1) from (0, 0). Back: (2, 0) is hidden from
  // (4, 1), and (0, 1) from (3, 0).
  EXPECT_EQ(
      greedy_straighten(grid, Walk{{0, 2}, {0, 1}, {0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {4, 1}}),
      (Walk{{0, 2}, {0, 0}, {3, 0}, {4, 1}}));
}

TEST(Tighten, BendsInTwoCellsAroundACorner) {
  // Greedy sight goes by the corner cells (0, 0) and (4, 0); between two cells on either side of a
  // corner the way is shorter: sqrt 2 for 2.
  const Grid grid = drawn({".....", ".###.", "....."});
  EXPECT_EQ(straighten(grid, Walk{{0, 2}, {0, 1}, {0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {4, 1}}),
            (Walk{{0, 2}, {0, 1}, {1, 0}, {3, 0}, {4, 1}}));
  EXPECT_EQ(straighten(grid, Walk{}), Walk{});
  EXPECT_EQ(straighten(grid, Walk{{0, 0}, {1, 0}, {2, 0}}), (Walk{{0, 0}, {2, 0}}));
  const Grid squeeze = drawn({"..#", ".#.", "..."});
  const Walk through{{0, 0}, {1, 0}, {2, 1}, {2, 2}};
  EXPECT_EQ(straighten(squeeze, through), through);
}

TEST(Straighten, KeepsASqueezeOfTheWalk) {
  const Grid grid = drawn({"..#", ".#.", "..."});
  const Walk through{{0, 0}, {1, 0}, {2, 1}, {2, 2}};
  EXPECT_EQ(greedy_straighten(grid, through), through);
  Straightener straightener;
  straightener.run(grid, through);
  EXPECT_TRUE(std::ranges::equal(straightener.cells(), through));
}

TEST(Straighten, FirstPassEqualsGreedySightAndTheResultIsValid) {
  std::mt19937 random(4);
  Straightener straightener;
  int bends = 0, shortened = 0;
  for (int round = 0; round < 3000; ++round) {
    const Grid grid =
        random_grid(random_in(2, 100, random), random_in(2, 40, random), (round % 6) * 7, random);
    const bool diagonal = round % 4 >= 2;
    const Corners corners = diagonal ? Corners(round % 3) : Corners::forbid;
    const Walk walk = random_walk(grid, random_in(0, 400, random), diagonal, corners, random);
    if (walk.empty()) continue;
    double most = length_of(pulled(grid, walk)) * (1 + 1e-12);
    for (const bool tight : {false, true}) {
      tight ? straightener.straighten(grid) : straightener.run(grid, walk);
      const auto vertices = straightener.vertices();
      const auto cells = straightener.cells();
      ASSERT_EQ(vertices.front(), walk.front());
      ASSERT_EQ(vertices.back(), walk.back());
      ASSERT_EQ(cells.front(), walk.front());
      ASSERT_EQ(cells.back(), walk.back());
      const double length = length_of(vertices);
      ASSERT_LE(length, most);
      ASSERT_TRUE(one_piece(grid, cells, corners == Corners::allow && diagonal));
      ASSERT_TRUE(passes(cells, vertices));
      if (corners != Corners::allow) {
        std::vector<Point> path;
        for (const Cell c : vertices) path.push_back(centre(c));
        ASSERT_TRUE(rule::Checker(grid).obeys(path));
      }
      shortened += tight && length < most;
      most = length;
      bends += tight ? 0 : static_cast<int>(vertices.size()) - 2;
    }
  }
  EXPECT_GT(bends, 5000);
  EXPECT_GT(shortened, 500);
}

TEST(Straighten, EndsWhereNeitherDirectionShortens) {
  std::mt19937 random(5);
  Straightener straightener;
  int pulled_paths = 0;
  for (int round = 0; round < 500; ++round) {
    const Grid grid = random_grid(80, 50, (round % 5) * 6, random);
    const Walk walk = random_walk(grid, 600, false, Corners::forbid, random);
    if (walk.empty()) continue;
    ++pulled_paths;
    for (const bool tight : {false, true}) {
      tight ? straightener.straighten(grid) : straightener.run(grid, walk);
      const double length = length_of(straightener.vertices());
      Walk cells(straightener.cells().begin(), straightener.cells().end());
      for (int way = 0; way < 2; ++way) {
        ASSERT_GE(length_of(pulled(grid, cells)), length * (1 - 1e-11));
        std::reverse(cells.begin(), cells.end());
      }
    }
  }
  EXPECT_GT(pulled_paths, 300);
}

// As short as vertices that are left out, or moved by a cell, can make it.
TEST(Straighten, NoVertexIsToSpareOrBetterACellFurther) {
  std::mt19937 random(9);
  Straightener straightener;
  std::size_t vertices = 0;
  for (int round = 0; round < 1000; ++round) {
    const Grid grid = random_grid(60, 40, 5 + (round % 5) * 5, random);
    const Walk walk = random_walk(grid, 400, false, Corners::forbid, random);
    if (walk.empty()) continue;
    straightener.run(grid, walk);
    straightener.straighten(grid);
    const auto path = straightener.vertices();
    for (std::size_t i = 1; i + 1 < path.size(); ++i, ++vertices) {
      const Cell a = path[i - 1], b = path[i], c = path[i + 1];
      const double least = length_of(Walk{a, b, c}) * (1 - 1e-9);
      if (visible(grid, a, c)) {
        ASSERT_GE(length_of(Walk{a, c}), least) << "vertex " << i;
      }
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell to{b.x + dx, b.y + dy};
          if (grid.blocked(to) || !visible(grid, a, to) || !visible(grid, to, c)) continue;
          ASSERT_GE(length_of(Walk{a, to, c}), least) << "vertex " << i;
        }
      }
    }
  }
  EXPECT_GT(vertices, 2000u);
}

TEST(Straighten, AllocatesNothingTheSecondTime) {
  std::mt19937 random(6);
  const Grid grid = random_grid(300, 200, 10, random);
  const Walk walk = long_walk(grid, random);
  Straightener straightener;
  LoopCutter cutter;
  EXPECT_EQ(allocations_of_the_second([&] {
              straightener.run(grid, cutter.cut(grid, walk));
              straightener.straighten(grid);
            }),
            0);
}

TEST(Straighten, PollsAndReturnsAValidPathWhenStopped) {
  // A wide empty map: each row costs a scan of its words.
  const Grid grid(32768, 2048);
  Walk walk;
  for (int y = 0; y < 2048; ++y) {
    for (int i = 0; i < 16; ++i) walk.push_back({y * 16 + i, y});
  }
  const CountingTime counted(1 << 30);
  Straightener straightener;
  straightener.run(grid, walk, counted.is_up());
  EXPECT_EQ(straightener.vertices().size(), 2u);
  EXPECT_GE(counted.polls(), 8);  // at least 2048 rows of up to 512 words in two passes
  const CountingTime up(0);
  straightener.run(grid, walk, up.is_up());
  EXPECT_EQ(up.polls(), 1);
  EXPECT_TRUE(std::ranges::equal(straightener.vertices(), walk));
  EXPECT_TRUE(one_piece(grid, straightener.cells(), false));
}

// Distances inside a set of cells, by plain breadth-first search.
int moves_inside(const Grid& grid, const Walk& walk, bool diagonal, Corners corners) {
  std::vector<int> distance(grid.width() * grid.height(), -2);
  const auto at = [&](Cell c) -> int& { return distance[c.y * grid.width() + c.x]; };
  for (const Cell c : walk) at(c) = -1;
  at(walk.front()) = 0;
  flood(walk.front(), diagonal, [&](Cell from, Cell to) {
    if (!grid.contains(to) || at(to) != -1) return false;
    if (from.x != to.x && from.y != to.y && !passes_corner(grid, corners, from, to)) return false;
    at(to) = at(from) + 1;
    return true;
  });
  return at(walk.back());
}

TEST(LoopCutter, FindsTheFewestMovesInsideTheWalk) {
  std::mt19937 random(7);
  LoopCutter cutter;
  std::int64_t cut = 0;
  for (int round = 0; round < 3000; ++round) {
    const Grid grid =
        random_grid(random_in(1, 80, random), random_in(1, 40, random), (round % 6) * 7, random);
    const bool diagonal = round % 2 == 0;
    const auto corners = Corners(round % 3);
    const Walk walk = random_walk(grid, random_in(0, 500, random), diagonal, corners, random);
    if (walk.empty()) continue;
    const auto way = cutter.cut(grid, walk, diagonal, corners);
    ASSERT_EQ(way.front(), walk.front());
    ASSERT_EQ(way.back(), walk.back());
    ASSERT_EQ(static_cast<int>(way.size()) - 1, moves_inside(grid, walk, diagonal, corners));
    for (std::size_t i = 0; i < way.size(); ++i) {
      ASSERT_NE(std::find(walk.begin(), walk.end(), way[i]), walk.end());
      if (i == 0) continue;
      const int dx = std::abs(way[i].x - way[i - 1].x);
      const int dy = std::abs(way[i].y - way[i - 1].y);
      ASSERT_EQ(std::max(dx, dy), 1);
      ASSERT_TRUE(diagonal || dx + dy == 1);
      const int sides = grid.free({way[i].x, way[i - 1].y}) + grid.free({way[i - 1].x, way[i].y});
      ASSERT_TRUE(corners != Corners::forbid || sides == 2);
    }
    cut += static_cast<std::int64_t>(walk.size() - way.size());
  }
  EXPECT_GT(cut, 100000);
}

TEST(LoopCutter, PollsAndFindsNothingWhenStopped) {
  const Grid grid(300, 200);
  Walk snake;
  for (int i = 0; i < 300 * 200; ++i) {
    const int y = i / 300;
    snake.push_back({y % 2 == 0 ? i % 300 : 299 - i % 300, y});
  }
  std::swap(snake.front(), snake.back());  // of a set of cells, only the ends matter
  const CountingTime counted(1 << 30);
  LoopCutter cutter;
  EXPECT_EQ(cutter.cut(grid, snake, false, Corners::forbid, counted.is_up()).size(), 200u);
  // Cells and the tiles' neighbours, then the cells nearer to the end.
  const int polls = (300 * 200 + 38 * 25 * 4) / 4096 + 199 * 200 / 2 / 4096;
  EXPECT_EQ(counted.polls(), polls);
  for (int looks = 0; looks < polls; ++looks) {
    const CountingTime up(looks);
    EXPECT_TRUE(cutter.cut(grid, snake, false, Corners::forbid, up.is_up()).empty()) << looks;
    EXPECT_EQ(up.polls(), looks + 1);
  }
}

TEST(Straighten, WhatIsNoWalkIsRefused) {
  const Grid grid = with_blocked(6, 4, {{2, 1}});
  for (const Walk& cells : {Walk{{0, 0}, {2, 0}},
                            {{0, 0}, {1, 0}, {2, 1}},
                            {{5, 3}, {6, 3}},
                            {{0, 0}, {0, 2}},
                            {{2, 1}}}) {
    EXPECT_THROW(straighten(grid, cells), Error);
    EXPECT_THROW(greedy_straighten(grid, cells), Error);
  }
}

}  // namespace
}  // namespace lasius
