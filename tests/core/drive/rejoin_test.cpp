#include "core/drive/rejoin.h"

#include <gtest/gtest.h>

#include <vector>

namespace lasius {
namespace {

TEST(Rejoin, GoesOnlyWhereItSees) {
  Grid grid(30, 30);
  for (int x = 0; x < 30; ++x) grid.set_blocked({x, 15});
  const auto space = disc::DiscSpace::make(grid, 1.0);
  ASSERT_TRUE(space);
  const std::vector<Point> way{{3, 5}, {27, 5}};
  std::vector<Point> path = way;
  EXPECT_FALSE(rejoin(*space, {15, 25}, path));  // behind the wall
  EXPECT_EQ(path, way);
  EXPECT_TRUE(rejoin(*space, {15, 8}, path));
  EXPECT_EQ(path, (std::vector<Point>{{15, 8}, {27, 5}}));
}

}  // namespace
}  // namespace lasius
