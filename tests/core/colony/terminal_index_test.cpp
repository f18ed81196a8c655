// The terminal index of Li, Wang and Ma: its formulas, and its figures as far as they can be had.
#include "core/colony/terminal_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/params/schedule.h"
#include "lasius/plan/planner.h"
#include "tests/core/colony/walked_grid.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

TEST(TerminalIndex, AntsThatAreStuckDie) {
  const Planner pocket(drawn({".....",     //
                              "##.##",     //
                              "##.##"}));  // some of 30 ants walk down
  Params params("terminal-index");
  params.iterations = 1;
  const Request through{.start = {0, 0}, .goal = {4, 0}};
  const int arrived = pocket.plan(through, params).curves.arrived.at(0);
  EXPECT_GT(arrived, 0);
  EXPECT_LT(arrived, 30);
  params.dead_end = DeadEnd::backtrack;
  EXPECT_EQ(pocket.plan(through, params).curves.arrived.at(0), 30);
}

TEST(TerminalIndex, IsTheLeastKnownWayToTheGoal) {
  // Two ways from (2, 2) to (4, 2): straight, 2; by (3, 1), 2 sqrt(2). Unknown cells stay at 99.
  WalkedGrid trail(Params("terminal-index"), 99);
  trail.walk({kNorthEast, kSouthEast});
  trail.update();
  EXPECT_NEAR(trail.tau(2, 2), 2 * std::sqrt(2.0), 1e-5);
  trail.walk({kEast, kEast});
  trail.update();
  EXPECT_NEAR(trail.tau(4, 2), 0, 1e-5);
  EXPECT_NEAR(trail.tau(3, 2), 1, 1e-5);
  EXPECT_NEAR(trail.tau(3, 1), std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(trail.tau(2, 2), 2, 1e-5);  // the smaller value is kept
  EXPECT_NEAR(trail.tau(9, 9), 99, 1e-4);
}

/// Moves told by the compass: "NE5 E" are five to the north east and one to the east.
std::vector<std::uint8_t> moves_told(const std::string& strokes) {
  constexpr std::array<std::string_view, 8> kInScanOrder{"NW", "N",  "NE", "W",
                                                         "E",  "SW", "S",  "SE"};
  std::istringstream words(strokes);
  std::vector<std::uint8_t> moves;
  for (std::string word; words >> word;) {
    const std::size_t letters = std::min(word.find_first_of("0123456789"), word.size());
    const auto move = std::ranges::find(kInScanOrder, word.substr(0, letters));
    const int times = letters < word.size() ? std::stoi(word.substr(letters)) : 1;
    moves.insert(moves.end(), times, static_cast<std::uint8_t>(move - kInScanOrder.begin()));
  }
  return moves;
}

/// An ant that made these moves teaches the index: the length of its tour.
double learn(WalkedGrid& index, const std::string& strokes) {
  index.walk(moves_told(strokes));
  index.update();
  return index.lengths.back();
}

/// The length of the generation's answer.
double answer(WalkedGrid& index) {
  std::vector<std::uint8_t> way;
  best_known_way(index.rows.field, index.rows.moves, index.start, index.goal,
                 IndexAnswer::least_way, way);
  double length = 0;
  for (const int k : way) length += index.rows.moves[k].length;
  return length;
}

// Figures 4 to 6 are lost: two ways with the printed values. Its digits are cut off, not rounded.
TEST(TerminalIndex, JoinsTheGoodPartsOfTwoPathsOn4x4) {
  WalkedGrid index(Params("terminal-index"), 99, 4, {0, 3}, {3, 0});
  learn(index, "N2 E NE E");
  EXPECT_NEAR(index.tau(1, 1), 2.41, 0.01);  // kept when the second way would make it 3
  EXPECT_NEAR(index.tau(0, 3), 5.41, 0.01);
  learn(index, "NE N2 E2");
  EXPECT_NEAR(index.tau(3, 0), 0, 1e-6);
  EXPECT_NEAR(index.tau(2, 0), 1, 1e-6);
  EXPECT_NEAR(index.tau(1, 0), 2, 1e-6);
  EXPECT_NEAR(index.tau(1, 1), 2.41, 0.01);
  EXPECT_NEAR(index.tau(1, 2), 3.41, 0.01);
  EXPECT_NEAR(index.tau(0, 3), 4.82, 0.01);
  EXPECT_NEAR(answer(index), 4.82, 0.01);
}

// Figure 3's paths are lost, too: this is a reconstruction that meets every printed number. Node
// 266 is (6, 13) from the bottom left, here (6, 6); the source calculates with 1.414.
TEST(TerminalIndex, Figure3JoinsTwoLongPathsToTheOptimum) {
  WalkedGrid index(Params("terminal-index"), 99, 20, {0, 19}, {19, 0});
  EXPECT_NEAR(learn(index, "E N W N7 NE5 E SE S NE4 E3 NE4 E"), 35.80, 0.005);
  EXPECT_NEAR(index.tau(19, 0), 0, 1e-6);
  EXPECT_NEAR(index.tau(18, 0), 1, 1e-6);
  EXPECT_NEAR(index.tau(17, 1), 2.414, 0.001);
  EXPECT_NEAR(index.tau(6, 6), 17.726, 0.005);
  EXPECT_NEAR(learn(index, "E3 NE4 N7 NW SW N NE NE6 SE2 NE2 E3"), 38.04, 0.005);
  EXPECT_NEAR(index.tau(6, 6), 17.14, 0.005);
  EXPECT_NEAR(index.tau(0, 19), 30.97, 0.005);
  EXPECT_NEAR(answer(index), 30.97, 0.005);
}

// So far off that rounding hides a step.
TEST(TerminalIndex, CellsWithoutAWayDoNotHoldUpEachOther) {
  WalkedGrid index(Params("terminal-index"), 1 << 22);
  for (const int x : {4, 5}) index.rows.field.set_tau({x, 2}, 0, 1 << 21);
  forget_lost_ways(index.rows.field, index.grid, index.params.corners, index.rows.moves, index.goal,
                   {4, 2, 2, 1});
  for (const int x : {4, 5}) EXPECT_EQ(index.tau(x, 2), 1 << 22);
}

TEST(TerminalIndex, WeightsAreEquations8And9) {
  // At (3, 2), goal (10, 2): K(4, 2) = 0 is Kmin, so K' = K; unknown 99. East: the least weight.
  // Rows hold one over it.
  WalkedGrid trail(Params("terminal-index"), 99);
  trail.walk({kEast, kEast});
  trail.update();
  trail.rows.field.refresh(schedule(trail.params, 1), 1);
  const float* w = trail.rows.of({3, 2});
  // West, K = 2, d = 8, against north-west, K = 99, d = sqrt(65): (2/99)^0.9 (8/sqrt(65))^1.5.
  EXPECT_NEAR(w[0] / w[3], std::pow(2.0 / 99, 0.9) * std::pow(8 / std::sqrt(65.0), 1.5), 1e-6);
  EXPECT_EQ(std::max_element(w, w + 8) - w, kEast);
}

}  // namespace
}  // namespace lasius
