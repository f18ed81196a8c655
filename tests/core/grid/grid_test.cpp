#include "lasius/grid.h"

#include <gtest/gtest.h>

#include "lasius/error.h"

namespace lasius {
namespace {

TEST(Grid, StartsFreeWithABlockedBorder) {
  const Grid grid(65, 3);
  EXPECT_EQ(grid.words(), 2);
  EXPECT_EQ(grid.count_free(), 65 * 3);
  EXPECT_TRUE(grid.free({64, 2}));
  for (const Cell c : {Cell{-1, 0}, Cell{65, 0}, Cell{0, -1}, Cell{0, 3}}) {
    EXPECT_TRUE(grid.blocked(c)) << c.x << ',' << c.y;
  }
  // The words that stand for the border are readable and blocked.
  for (int y = -1; y <= 3; ++y) {
    EXPECT_EQ(grid.row(y)[-1], ~std::uint64_t{0}) << y;
    EXPECT_EQ(grid.row(y)[2], ~std::uint64_t{0}) << y;
  }
  EXPECT_EQ(grid.row(0)[1], ~std::uint64_t{1});
  EXPECT_EQ(grid.row(-1)[0], ~std::uint64_t{0});
  EXPECT_EQ(grid.row(3)[0], ~std::uint64_t{0});
}

TEST(Grid, SetsAndClearsSingleCells) {
  Grid grid(130, 2);
  grid.set_blocked({129, 1});
  EXPECT_TRUE(grid.blocked({129, 1}));
  EXPECT_EQ(grid.count_free(), 259);
  grid.set_blocked({129, 1}, false);
  EXPECT_EQ(grid, Grid(130, 2));
}

TEST(Grid, SetRowKeepsBitsPastTheWidthBlocked) {
  Grid grid(3, 1);
  const std::uint64_t row = 0b010;
  grid.set_row(0, &row);
  EXPECT_EQ(grid.row(0)[0], ~std::uint64_t{0b101});
}

TEST(Grid, HashTellsBitsAndShapesApart) {
  Grid changed(10, 10);
  changed.set_blocked({3, 4});
  EXPECT_NE(Grid(10, 10).hash(), changed.hash());
  EXPECT_NE(Grid(20, 5).hash(), Grid(5, 20).hash());
  EXPECT_EQ(Grid(10, 10).hash(), Grid(10, 10).hash());
}

TEST(Grid, RefusesSizesOutOfRange) {
  for (const auto& [w, h] :
       {std::pair{0, 5}, {5, 0}, {-1, 5}, {32769, 5}, {5, 32769}, {2147483647, 1}}) {
    EXPECT_THROW(Grid(w, h), Error) << w << 'x' << h;
  }
  try {
    Grid(5, 40000);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::invalid_parameter);
    EXPECT_STREQ(e.what(), "height is 40000; it must be 1 to 32768");
  }
}

}  // namespace
}  // namespace lasius
