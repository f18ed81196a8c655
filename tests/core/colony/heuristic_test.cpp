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

/// Expects a row to be value^beta of each move beside the largest.
void expect_shares(const std::vector<float>& row, std::vector<double> values) {
  for (double& value : values) value = std::pow(value, kBeta);
  const double largest = *std::max_element(values.begin(), values.end());
  ASSERT_GT(largest, 0);
  for (std::size_t k = 0; k < row.size(); ++k) {
    EXPECT_NEAR(row[k], values[k] / largest, 1e-6) << "move " << k << " of " << row.size();
  }
}

/// Expects the row of a cell to be of value(move), 0 where it is blocked.
void expect_row(const Grid& grid, Cell c, Cell goal, const Params& params,
                const std::function<double(Cell to)>& value) {
  const auto moves = moves_of(params.neighbours);
  std::vector<double> values;
  for (int k = 0; k < moves.count; ++k) {
    const Cell to = c + moves[k].to;
    values.push_back(grid.blocked(to) ? 0 : value(to));
  }
  expect_shares(row_of(grid, c, goal, params), values);
}

double apart(Cell a, Cell b) { return std::hypot(a.x - b.x, a.y - b.y); }

Params with(Heuristic heuristic, Neighbours neighbours = Neighbours::eight) {
  Params params("fan2004");
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
      std::vector<double> values;
      for (int k = 0; k < moves.count; ++k) {
        const Cell to = c + moves[k].to;
        const double way = row[k] > 0 ? length[to.y * grid.width() + to.x] : HUGE_VAL;
        values.push_back(1 / std::max(way, 0.5));
      }
      expect_shares(row, values);
    }
  }
}

}  // namespace
}  // namespace lasius
