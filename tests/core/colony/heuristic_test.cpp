// Each heuristic's row against its formula.
#include "core/colony/heuristic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/grid/move_rule.h"
#include "tests/oracle/relaxed_walks.h"
#include "tests/worlds/grids.h"

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
    const auto over = neighbours == Neighbours::four ? Neighbours::four : Neighbours::eight;
    const auto length = oracle::relaxed_walks(grid, goal, over, Corners::forbid);
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
