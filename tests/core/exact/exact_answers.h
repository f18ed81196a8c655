// What an exact answer must be, for tests of exact searches.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>

#include "core/exact/corner_graph.h"
#include "core/exact/exact.h"
#include "lasius/path/path.h"
#include "tests/core/base/counting_time.h"
#include "tests/oracle/visibility_graph.h"
#include "tests/worlds/grids.h"

namespace lasius {

/// A free cell, or nothing after many tries.
inline std::optional<Cell> random_free(const Grid& grid, std::mt19937& random) {
  for (int i = 0; i < 64; ++i) {
    const Cell c = random_cell(grid, random);
    if (grid.free(c)) return c;
  }
  return std::nullopt;
}

inline std::shared_ptr<exact::CornerGraph> graph_of(const Grid& grid,
                                                    const PrepareOptions& options = {
                                                        .threads = 1}) {
  Preparation report;
  return exact::CornerGraph::make(grid, options, report);
}

/// The answer of a search that may have answered others before.
inline ExactAnswer solve(ExactSearch& search, const Grid& grid, Cell start, Cell goal,
                         const ExactOptions& options = {}, const StopCondition& stop = {}) {
  ExactAnswer answer;
  search.search(grid, centre(start), centre(goal), options, stop, answer);
  return answer;
}

inline void expect_path(const Grid& grid, Cell start, Cell goal, const ExactAnswer& answer) {
  ASSERT_FALSE(answer.path.empty());
  EXPECT_EQ(answer.path.front(), centre(start));
  EXPECT_EQ(answer.path.back(), centre(goal));
  EXPECT_EQ(answer.length, path_length(answer.path));
  const auto fault = path_fault(grid, answer.path);
  EXPECT_FALSE(fault.has_value()) << *fault;
}

/// The answer equals the optimum by brute force; true if there is a path.
inline bool expect_optimum(const Grid& grid, Cell start, Cell goal, const ExactAnswer& answer) {
  const auto shortest = oracle::VisibilityGraph(grid).shortest(start, goal);
  if (!shortest) {
    EXPECT_EQ(answer.end, ExactEnd::unreachable);
    EXPECT_TRUE(answer.path.empty());
    EXPECT_TRUE(std::isinf(answer.lower_bound));
    EXPECT_FALSE(answer.optimal);
    return false;
  }
  EXPECT_EQ(answer.end, ExactEnd::proven);
  EXPECT_TRUE(answer.optimal);
  EXPECT_NEAR(answer.length, shortest->length, 1e-9 * shortest->length);
  EXPECT_EQ(answer.lower_bound, answer.length);
  expect_path(grid, start, goal, answer);
  return true;
}

/// Searches again with every gap, by `solve(ExactOptions)`; counts the answers that need not be the
/// optimum.
template <class Solve>
int expect_gaps(const Grid& grid, Cell start, Cell goal, const Solve& solve) {
  const ExactAnswer exact = solve(ExactOptions{});
  if (!exact.optimal) return 0;
  int early = 0;
  for (const double gap : {0.3, 0.1, 0.02}) {
    const ExactAnswer near = solve(ExactOptions{gap});
    expect_path(grid, start, goal, near);
    EXPECT_LE(near.lower_bound, exact.length);
    EXPECT_GE(near.length, exact.length * (1 - 1e-12));
    EXPECT_LE(near.length, near.lower_bound * (1 + gap + 1e-6));
    early += near.end == ExactEnd::target_gap;
  }
  return early;
}

struct Stops {
  int stopped = 0, with_path = 0;
};

/// Stops the search `solve(StopCondition)` at its first look at the clock, the second and so on:
/// what it tells by then holds, and its bounds do not fall.
template <class Solve>
Stops expect_bounds_at_stops(const Grid& grid, Cell start, Cell goal, const Solve& solve) {
  Stops stops;
  const ExactAnswer exact = solve(StopCondition{});
  EXPECT_TRUE(exact.optimal);
  double last_bound = 0;
  for (int polls = 0; polls < 100; ++polls) {
    const CountingTime time(polls);
    const ExactAnswer cut = solve(time.is_up());
    if (cut.end != ExactEnd::stopped) {
      EXPECT_EQ(cut.path, exact.path);
      break;
    }
    ++stops.stopped;
    EXPECT_EQ(cut.cause, StopCondition::Cause::deadline);
    EXPECT_FALSE(cut.optimal);
    EXPECT_LE(cut.lower_bound, exact.length);
    EXPECT_GE(cut.lower_bound, last_bound);
    last_bound = cut.lower_bound;
    if (cut.path.empty()) continue;
    ++stops.with_path;
    EXPECT_GE(cut.length, exact.length * (1 - 1e-12));
    expect_path(grid, start, goal, cut);
  }
  return stops;
}

/// The answer equals that of the unprepared search; true if there is a path.
inline bool expect_unprepared(const Grid& grid, Cell start, Cell goal, ExactSearch& unprepared,
                              const ExactAnswer& answer) {
  const ExactAnswer expected = solve(unprepared, grid, start, goal);
  EXPECT_EQ(answer.end, expected.end);
  if (!expected.optimal) return false;
  EXPECT_NEAR(answer.length, expected.length, 1e-9 * expected.length);
  expect_path(grid, start, goal, answer);
  return true;
}

/// LASIUS_EXACT_GRIDS scales the random tests.
inline int scaled(int count) {
  const char* scale = std::getenv("LASIUS_EXACT_GRIDS");
  return scale == nullptr ? count : count * std::max(1, std::atoi(scale));
}

/// A small grid of a random size and density: half of them sparse, half on the edge of falling
/// apart.
inline Grid random_small_grid(int number, std::mt19937& random) {
  const int percent = number % 2 == 0 ? random_in(0, 40, random) : random_in(30, 60, random);
  return random_grid(random_in(2, 12, random), random_in(2, 12, random), percent, random);
}

/// 64 x 64: half of them nearly empty, half on the edge of falling apart.
inline Grid random_large_grid(int number, std::mt19937& random) {
  const int percent = number % 2 == 0 ? random_in(0, 5, random) : random_in(30, 45, random);
  return random_grid(64, 64, percent, random);
}

/// A few blocks of up to 4 x 4 cells on a grid of 400 x 40 or 40 x 400: long views.
inline Grid random_sparse_grid(bool wide, std::mt19937& random) {
  Grid grid(wide ? 400 : 40, wide ? 40 : 400);
  for (int blocks = random_in(5, 200, random); blocks > 0; --blocks) {
    const Cell at = random_cell(grid, random);
    const int side = random_in(1, 4, random);
    for (const Cell c : cells_of({at.x, at.y, side, side})) {
      if (grid.contains(c)) grid.set_blocked(c);
    }
  }
  return grid;
}

/// A question on a map.
struct Puzzle {
  Grid grid;
  Cell start, goal;
};

/// As long or as tall as maps get, with walls that have a gap at one end, on either side in turn:
/// the path winds round every one.
inline Puzzle widest_puzzle(bool tall) {
  constexpr int kLength = Grid::kMaxSide;
  const auto cell = [tall](int along, int across) {
    return tall ? Cell{across, along} : Cell{along, across};
  };
  Puzzle puzzle{Grid(tall ? 5 : kLength, tall ? kLength : 5), cell(0, 2), cell(kLength - 1, 1)};
  for (int wall = 0; wall < 12; ++wall) {
    for (int k = 0; k < 4; ++k) {
      puzzle.grid.set_blocked(cell(1500 + 2500 * wall, wall % 2 == 0 ? k : 4 - k));
    }
  }
  return puzzle;
}

}  // namespace lasius
