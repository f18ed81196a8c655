#include "core/grid/move_rule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace lasius {
namespace {

using kernels::Move;
using kernels::Moves;
using kernels::Offset;

std::set<std::pair<int, int>> offsets(Neighbours n) {
  std::set<std::pair<int, int>> set;
  const Moves moves = moves_of(n);
  for (int k = 0; k < moves.count; ++k) set.emplace(moves[k].to.dx, moves[k].to.dy);
  return set;
}

TEST(Moves, CountsAreTheNeighbourhoodsNames) {
  EXPECT_EQ(moves_of(Neighbours::four).count, 4);
  EXPECT_EQ(moves_of(Neighbours::eight).count, 8);
  EXPECT_EQ(moves_of(Neighbours::sixteen).count, 16);
  EXPECT_EQ(moves_of(Neighbours::sixteen_knight).count, 16);
  EXPECT_EQ(moves_of(Neighbours::twenty_four).count, 24);
  EXPECT_EQ(moves_of(Neighbours::thirty_two).count, 32);
}

TEST(Moves, StandInScanOrderWithTheirLengths) {
  for (const auto n :
       {Neighbours::four, Neighbours::eight, Neighbours::sixteen, Neighbours::sixteen_knight,
        Neighbours::twenty_four, Neighbours::thirty_two}) {
    const Moves moves = moves_of(n);
    for (int k = 0; k < moves.count; ++k) {
      const auto [dx, dy] = moves[k].to;
      EXPECT_DOUBLE_EQ(moves[k].length, std::hypot(dx, dy));
      if (k == 0) continue;
      const auto [px, py] = moves[k - 1].to;
      EXPECT_LT(std::pair(py, px), std::pair(dy, dx));
    }
    for (const auto& [dx, dy] : offsets(n)) EXPECT_TRUE(offsets(n).count({-dx, -dy}));
  }
}

TEST(Moves, SixteenLengthensStridesAndKnightsBringDirections) {
  EXPECT_TRUE(offsets(Neighbours::sixteen).count({-2, 2}));
  EXPECT_FALSE(offsets(Neighbours::sixteen).count({1, 2}));
  EXPECT_TRUE(offsets(Neighbours::sixteen_knight).count({1, 2}));
  EXPECT_FALSE(offsets(Neighbours::sixteen_knight).count({2, 2}));
  EXPECT_TRUE(offsets(Neighbours::thirty_two).count({3, -3}));
}

TEST(Moves, SweepWhatTheSegmentBetweenCentresCrosses) {
  const auto find = [](int dx, int dy) {
    const Moves moves = moves_of(Neighbours::thirty_two);
    for (int k = 0; k < moves.count; ++k) {
      if (moves[k].to.dx == dx && moves[k].to.dy == dy) return moves[k];
    }
    return Move{};
  };
  const Move knight = find(1, 2);  // (0, 0) (0, 1) (1, 1) (1, 2), no lattice point
  ASSERT_EQ(knight.swept_count, 2);
  EXPECT_EQ(knight.swept[0], (Offset{0, 1}));
  EXPECT_EQ(knight.swept[1], (Offset{1, 1}));
  EXPECT_EQ(knight.corner_count, 0);

  const Move diagonal = find(-2, 2);  // through (-1, 1), two lattice points
  ASSERT_EQ(diagonal.swept_count, 1);
  EXPECT_EQ(diagonal.swept[0], (Offset{-1, 1}));
  ASSERT_EQ(diagonal.corner_count, 2);
  EXPECT_EQ(diagonal.corners[0][0], (Offset{-1, 0}));
  EXPECT_EQ(diagonal.corners[0][1], (Offset{0, 1}));
  EXPECT_EQ(diagonal.corners[1][0], (Offset{-2, 1}));
  EXPECT_EQ(diagonal.corners[1][1], (Offset{-1, 2}));

  const Move straight = find(0, -3);
  ASSERT_EQ(straight.swept_count, 2);
  EXPECT_EQ(straight.swept[0], (Offset{0, -1}));
  EXPECT_EQ(straight.swept[1], (Offset{0, -2}));
  EXPECT_EQ(straight.corner_count, 0);
}

}  // namespace
}  // namespace lasius
