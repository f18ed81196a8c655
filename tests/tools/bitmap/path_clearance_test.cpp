#include "tools/bitmap/path_clearance.h"

#include <gtest/gtest.h>

#include "lasius/grid/clearance.h"
#include "tests/worlds/grids.h"

namespace lasius::tool {
namespace {

TEST(DistanceToBlocked, WorkedByHand) {
  Grid grid = with_blocked(20, 20, {{10, 10}});
  EXPECT_DOUBLE_EQ(distance_to_blocked(grid, {8.5, 10.5}), 1.5);  // to the square's left edge
  EXPECT_DOUBLE_EQ(distance_to_blocked(grid, {7, 6}), 5);         // to its corner: 3, 4, 5
  EXPECT_DOUBLE_EQ(distance_to_blocked(grid, {12.25, 10.75}), 1.25);
  EXPECT_DOUBLE_EQ(distance_to_blocked(grid, {1.5, 10}), 1.5);  // the outside is nearer
  EXPECT_DOUBLE_EQ(distance_to_blocked(grid, {10, 10}), 0);     // a corner that the path touches
  EXPECT_DOUBLE_EQ(distance_to_blocked(grid, {10.5, 10.5}), 0);
}

TEST(DistanceToBlocked, EndsAtTheMost) {
  const Grid wide(400, 400);
  EXPECT_DOUBLE_EQ(distance_to_blocked(wide, {200, 200}), kMostClearance);
  EXPECT_DOUBLE_EQ(distance_to_blocked(wide, {63.5, 200}), 63.5);
}

TEST(DistanceToBlocked, AsTheClearanceFieldAtCentres) {
  Grid grid(31, 23);
  for (int i = 0; i < 40; ++i) grid.set_blocked({(i * 17 + 5) % 31, (i * 7 + 3) % 23});
  const ClearanceField field = clearance(grid);
  for (const Cell c : cells_of(grid))
    ASSERT_NEAR(distance_to_blocked(grid, centre(c)), field.at(c), 1e-12) << c.x << ", " << c.y;
}

TEST(ClearanceAlong, SamplesAreEvenAndEndWithThePath) {
  const Grid grid = walled(30, 11, {{29, 0, 1, 11}});
  const std::vector<Point> path{{9, 5.5}, {19, 5.5}, {27, 5.5}};  // 18 long, to 2 from the wall
  const auto along = clearance_along(grid, path, 18);
  EXPECT_DOUBLE_EQ(along.step, 0.5);
  ASSERT_EQ(along.values.size(), 37U);
  EXPECT_DOUBLE_EQ(along.values.front(), 5.5);  // the upper and lower edge
  EXPECT_DOUBLE_EQ(along.values[30], 5);        // at x 24
  EXPECT_DOUBLE_EQ(along.values.back(), 2);
}

TEST(ClearanceAlong, APointAndALongPath) {
  const Grid grid(2000, 3);
  EXPECT_EQ(clearance_along(grid, {{4.5, 1.5}}, 0).values, (std::vector{1.5, 1.5}));
  const auto line = clearance_along(grid, {{0.5, 1.5}, {1999.5, 1.5}}, 1999);
  EXPECT_EQ(line.values.size(), ClearanceAlong::kMostSamples + 1U);
}

}  // namespace
}  // namespace lasius::tool
