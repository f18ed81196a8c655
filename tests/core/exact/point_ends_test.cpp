// Exact paths that begin and end at any points, against brute force.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/exact/exact.h"
#include "core/exact/prepared_search.h"
#include "core/grid/grid_view.h"
#include "lasius/grid/generate.h"
#include "tests/core/exact/exact_answers.h"
#include "tests/oracle/plane_rule.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

using kernels::fine;

/// A point that touches a free cell: anywhere, or on a lattice so coarse that it lies on edges,
/// corners and lines through corners.
std::optional<Point> random_point(const Grid& grid, std::mt19937& random) {
  constexpr int kUnit = oracle::VisibilityGraph::kUnit;
  constexpr int kCoarse[] = {1, 2, 4, 8, kUnit, kUnit};
  const int parts = kCoarse[random() % std::size(kCoarse)];
  const auto coordinate = [&](int side) {
    return static_cast<double>(random() % static_cast<unsigned>(side * parts + 1)) / parts;
  };
  for (int i = 0; i < 64; ++i) {
    const Point p{coordinate(grid.width()), coordinate(grid.height())};
    const auto at = fine(p.x, p.y);
    if (kernels::sees_fine(view_of(grid), at, at)) return p;
  }
  return std::nullopt;
}

void expect_answer(const Grid& grid, Point start, Point goal, const ExactAnswer& answer,
                   const std::optional<oracle::Shortest>& shortest) {
  if (!shortest) {
    EXPECT_EQ(answer.end, ExactEnd::unreachable);
    EXPECT_TRUE(answer.path.empty());
    return;
  }
  ASSERT_EQ(answer.end, ExactEnd::proven);
  EXPECT_TRUE(answer.optimal);
  EXPECT_NEAR(answer.length, shortest->length, 1e-9 * (1 + shortest->length));
  EXPECT_EQ(answer.path.front(), start);
  EXPECT_EQ(answer.path.back(), goal);
  EXPECT_EQ(answer.length, path_length(answer.path));
  EXPECT_EQ(path_fault(grid, answer.path), std::nullopt);
  EXPECT_TRUE(start == goal || rule::Checker(grid).obeys(answer.path));
}

struct Searches {
  ExactSearch plain;
  exact::PreparedSearch prepared;
  int reached = 0, not_reached = 0, bent = 0;

  void expect_exact(const Grid& grid, std::mt19937& random) {
    const auto start = random_point(grid, random), goal = random_point(grid, random);
    if (!start || !goal) return;
    const auto shortest = oracle::VisibilityGraph(grid).shortest(*start, *goal);
    const auto graph = graph_of(grid);
    for (const auto& [from, to] : {std::pair{*start, *goal}, std::pair{*goal, *start}}) {
      SCOPED_TRACE(testing::Message() << from.x << ',' << from.y << " to " << to.x << ',' << to.y
                                      << " on " << grid.width() << " x " << grid.height());
      ExactAnswer answer;
      plain.search(grid, from, to, {}, {}, answer);
      expect_answer(grid, from, to, answer, shortest);
      prepared.search(grid, *graph, from, to, {}, {}, answer);
      expect_answer(grid, from, to, answer, shortest);
      for (const double gap : {0.3, 0.05}) {
        plain.search(grid, from, to, {gap}, {}, answer);
        if (!shortest) continue;
        EXPECT_LE(answer.lower_bound, shortest->length * (1 + 1e-12));
        EXPECT_LE(answer.length, answer.lower_bound * (1 + gap + 1e-6));
        EXPECT_EQ(path_fault(grid, answer.path), std::nullopt);
      }
      bent += answer.path.size() > 2;
    }
    ++(shortest ? reached : not_reached);
  }
};

TEST(PointEnds, EqualBruteForceOnSmallGrids) {
  std::mt19937 random(20261127);
  Searches searches;
  for (int i = 0; i < scaled(2000) && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("grid " + std::to_string(i));
    searches.expect_exact(random_small_grid(i, random), random);
  }
  EXPECT_GT(searches.reached, 1000);
  EXPECT_GT(searches.not_reached, 100);
  EXPECT_GT(searches.bent, 500);
}

TEST(PointEnds, EqualBruteForceOnLargerGrids) {
  std::mt19937 random(20261128);
  Searches searches;
  for (int i = 0; i < scaled(100) && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("grid " + std::to_string(i));
    searches.expect_exact(
        i % 4 == 0 ? random_sparse_grid(i % 8 == 0, random) : random_large_grid(i, random), random);
  }
  EXPECT_GT(searches.reached, 60);
}

/// Sight in 128 bits is sight in half cells where both are asked.
TEST(PointEnds, FineSightIsThatOfHalfCells) {
  std::mt19937 random(5);
  int seen = 0, hidden = 0;
  for (int i = 0; i < 400; ++i) {
    const Grid grid = random_small_grid(i, random);
    const auto map = view_of(grid);
    for (int k = 0; k < 50; ++k) {
      const auto at = [&](int side) {
        return static_cast<int>(random() % static_cast<unsigned>(2 * side + 1));
      };
      const kernels::HalfPoint a{at(grid.width()), at(grid.height())};
      const kernels::HalfPoint b{at(grid.width()), at(grid.height())};
      const bool sees = kernels::sees(map, a, b);
      ++(sees ? seen : hidden);
      ASSERT_EQ(kernels::sees_fine(map, fine(a), fine(b)), sees)
          << i << ": " << a.x << ',' << a.y << " to " << b.x << ',' << b.y;
    }
  }
  EXPECT_GT(seen, 1000);
  EXPECT_GT(hidden, 1000);
}

/// What no fixed point of a scan tells apart: a start a hair beside a wall, and a gap in it.
TEST(PointEnds, AHairBesideAWall) {
  const Grid grid = walled(40, 20, {{10, 0, 1, 9}, {10, 10, 1, 10}, {12, 5, 20, 4}});
  for (const double hair : {1e-3, 1e-6, 1e-9, 1e-12}) {
    for (const auto& [start, goal] : {std::pair{Point{10 - hair, 0.5}, Point{30.5, 0.5}},
                                      std::pair{Point{9.5, 9 + hair}, Point{39.5, 9 + hair}},
                                      std::pair{Point{hair, 19.5}, Point{11 + hair, 10 - hair}}}) {
      ExactSearch search;
      ExactAnswer there, back;
      search.search(grid, start, goal, {}, {}, there);
      search.search(grid, goal, start, {}, {}, back);
      ASSERT_TRUE(there.optimal && back.optimal) << hair;
      EXPECT_NEAR(there.length, back.length, 1e-12 * there.length);
      EXPECT_EQ(path_fault(grid, there.path), std::nullopt);
      // As far as a hair's difference lets it be.
      const auto near = [](Point p) {
        return Point{std::round(1024 * p.x) / 1024, std::round(1024 * p.y) / 1024};
      };
      const auto shortest = oracle::VisibilityGraph(grid).shortest(near(start), near(goal));
      EXPECT_NEAR(there.length, shortest->length, 4 * hair + 4e-3);
    }
  }
}

}  // namespace
}  // namespace lasius
