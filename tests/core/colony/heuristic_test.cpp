// Each heuristic's row against its formula.
#include "core/colony/heuristic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "core/grid/move_rule.h"
#include "tests/worlds/random_grid.h"

namespace lasius {
namespace {

constexpr double kBeta = 1.5;

/// The row of one cell.
std::vector<float> row_of(const Grid& grid, Cell c, Cell goal, const Params& params) {
  const auto moves = moves_of(params.neighbours);
  HeuristicRows rows;
  rows.reset(grid, moves, goal, params, {});
  std::array<float, kernels::kMaxMoves> row;
  rows.fill(c, kBeta, row.data());
  return {row.begin(), row.begin() + moves.count};
}

/// Expects the row of a cell to be value(move)^beta beside the largest, 0 where it is blocked.
void expect_row(const Grid& grid, Cell c, Cell goal, const Params& params,
                const std::function<double(Cell to)>& value) {
  const auto moves = moves_of(params.neighbours);
  std::vector<double> expected;
  for (int k = 0; k < moves.count; ++k) {
    const Cell to{c.x + moves[k].to.dx, c.y + moves[k].to.dy};
    expected.push_back(grid.blocked(to) ? 0 : std::pow(value(to), kBeta));
  }
  const double largest = *std::max_element(expected.begin(), expected.end());
  const auto row = row_of(grid, c, goal, params);
  for (int k = 0; k < moves.count; ++k) {
    EXPECT_NEAR(row[k], expected[k] / largest, 1e-6) << "move " << k << " of " << moves.count;
  }
}

double apart(Cell a, Cell b) { return std::hypot(a.x - b.x, a.y - b.y); }

Params with(Heuristic heuristic, Neighbours neighbours = Neighbours::eight) {
  Params params;
  params.heuristic = heuristic;
  params.neighbours = neighbours;
  return params;
}

TEST(HeuristicRows, FollowTheirFormulas) {
  Grid grid(20, 20);
  const Cell c{3, 4}, goal{9, 6};
  grid.set_blocked({2, 4});
  const auto params = [](Heuristic heuristic) { return with(heuristic, Neighbours::four); };
  expect_row(grid, c, goal, params(Heuristic::uniform), [](Cell) { return 1; });
  expect_row(grid, c, goal, params(Heuristic::inverse_distance),
             [&](Cell to) { return 1 / apart(to, goal); });
  expect_row(grid, c, goal, params(Heuristic::distance), [&](Cell to) { return apart(to, goal); });
  expect_row(grid, c, goal, params(Heuristic::goal_angle), [&](Cell to) {
    const double turn = std::abs(std::atan2(to.y - c.y, to.x - c.x) - std::atan2(2, 6));
    return 1 / (1 + std::min(turn, 2 * std::numbers::pi - turn) / (std::numbers::pi / 4));
  });
}

TEST(HeuristicRows, TheGoalIsHalfACellAway) {
  const Grid grid(20, 20);
  const Cell c{3, 4}, goal{4, 4};
  for (const auto heuristic : {Heuristic::inverse_distance, Heuristic::distance_field}) {
    const auto row = row_of(grid, c, goal, with(heuristic, Neighbours::four));
    EXPECT_EQ(row[2], 1);
    EXPECT_NEAR(row[1], std::pow(0.5 / 2, kBeta), 1e-6) << "west, 2 from the goal";
  }
}

/// Lengths of the shortest ways to the goal, by relaxing until nothing changes.
std::vector<double> ways(const Grid& grid, Cell goal, bool diagonal) {
  std::vector<double> length(static_cast<std::size_t>(grid.width()) * grid.height(),
                             std::numeric_limits<double>::infinity());
  const auto at = [&](Cell c) -> double& { return length[c.y * grid.width() + c.x]; };
  at(goal) = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        if (grid.blocked({x, y})) continue;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            const Cell to{x + dx, y + dy};
            if (grid.blocked(to) || (dx != 0 && dy != 0 && !diagonal)) continue;
            if (grid.blocked({x + dx, y}) || grid.blocked({x, y + dy})) continue;
            const double through = at(to) + std::hypot(dx, dy);
            if (through >= at({x, y}) - 1e-9) continue;
            at({x, y}) = through;
            changed = true;
          }
        }
      }
    }
  }
  return length;
}

// Ways over 4 neighbours where ants move to 4, over 8 where they move to 8 or more.
TEST(HeuristicRows, DistanceFieldsAreOfTheAntsNeighbours) {
  const Grid grid = drawn({"..........",  //
                           ".########.",  //
                           "........#.",  //
                           "..####..#.",  //
                           "..........",  //
                           ".........."});
  const Cell goal{9, 0};
  for (const auto neighbours : {Neighbours::four, Neighbours::eight, Neighbours::sixteen}) {
    const auto length = ways(grid, goal, neighbours != Neighbours::four);
    for (const Cell c : {Cell{7, 3}, Cell{0, 2}, Cell{9, 5}, Cell{1, 5}}) {
      const auto row = row_of(grid, c, goal, with(Heuristic::distance_field, neighbours));
      const auto moves = moves_of(neighbours);
      double largest = 0;
      std::vector<double> expected;
      for (int k = 0; k < moves.count; ++k) {
        const Cell to{c.x + moves[k].to.dx, c.y + moves[k].to.dy};
        const double way = row[k] > 0 ? length[to.y * grid.width() + to.x] : HUGE_VAL;
        expected.push_back(std::pow(1 / std::max(way, 0.5), kBeta));
        largest = std::max(largest, expected.back());
      }
      ASSERT_GT(largest, 0);
      for (int k = 0; k < moves.count; ++k) {
        EXPECT_NEAR(row[k], expected[k] / largest, 1e-6) << "move " << k << " of " << moves.count;
      }
    }
  }
}

}  // namespace
}  // namespace lasius
