#include "lasius/grid/grid.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "lasius/base/error.h"
#include "tests/core/base/refusal.h"
#include "tests/worlds/grids.h"

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
  EXPECT_EQ(refusal([] { Grid(5, 40000); }), "height is 40000; it must be 1 to 32768");
}

// Widths around a word, polarities, and values other than 0 and 1.
TEST(Grid, FromBytesIsCellByCell) {
  std::mt19937 random(5);
  for (const int width : {1, 7, 8, 63, 64, 65, 130}) {
    for (const Nonzero nonzero : {Nonzero::blocked, Nonzero::free}) {
      const int height = 3;
      std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width) * height);
      for (auto& byte : bytes) byte = random() % 3 == 0 ? 0 : static_cast<std::uint8_t>(random());
      const Grid grid(width, height, bytes, nonzero);
      const Grid expected = grid_of(width, height, [&](int x, int y) {
        const bool set = bytes[static_cast<std::size_t>(y) * width + x] != 0;
        return set == (nonzero == Nonzero::blocked);
      });
      EXPECT_EQ(grid, expected) << width;
      const auto back = grid.bytes(nonzero);
      ASSERT_EQ(back.size(), bytes.size());
      for (std::size_t i = 0; i < back.size(); ++i) EXPECT_EQ(back[i], bytes[i] != 0 ? 1 : 0);
    }
  }
}

TEST(Grid, RectanglesAreFilledPastedAndRead) {
  Grid grid(150, 9);
  const Rectangle part{60, 2, 75, 5};
  grid.fill(part, true);
  for (const Cell c : cells_of(grid)) {
    const bool inside = c.x >= 60 && c.x < 135 && c.y >= 2 && c.y < 7;
    EXPECT_EQ(grid.blocked(c), inside) << c.x << ", " << c.y;
  }
  EXPECT_EQ(grid.count_free(), 150 * 9 - 75 * 5);
  std::vector<std::uint8_t> bytes(75 * 5);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = i % 7 == 0;
  grid.paste(part, bytes, Nonzero::free);
  EXPECT_EQ(grid.bytes(part, Nonzero::free), bytes);
  EXPECT_TRUE(grid.free({59, 2}));
  EXPECT_TRUE(grid.free({60, 2}));
  EXPECT_TRUE(grid.blocked({61, 2}));
  EXPECT_TRUE(grid.blocked({150, 2}));  // the border outside stays shut
  grid.fill(false);
  EXPECT_EQ(grid, Grid(150, 9));
  grid.fill({3, 3, 0, 0}, true);
  EXPECT_EQ(grid, Grid(150, 9));
}

TEST(Grid, RectanglesAndBytesThatDoNotFitAreRefused) {
  Grid grid(10, 5);
  const std::vector<std::uint8_t> bytes(50);
  EXPECT_THROW(Grid(10, 5, std::span(bytes).first(49), Nonzero::blocked), Error);
  EXPECT_THROW(Grid(10, 0, bytes, Nonzero::blocked), Error);
  for (const Rectangle part : {Rectangle{-1, 0, 2, 2},
                               {0, -1, 2, 2},
                               {9, 0, 2, 2},
                               {0, 4, 2, 2},
                               {0, 0, -1, 2},
                               {0, 0, 2, -1},
                               {2147483647, 0, 2, 2}}) {
    EXPECT_THROW(grid.fill(part, true), Error);
    EXPECT_THROW(grid.paste(part, bytes, Nonzero::free), Error);
    EXPECT_THROW((void)grid.bytes(part, Nonzero::free), Error);
  }
  EXPECT_THROW(grid.paste({0, 0, 10, 5}, std::span(bytes).first(49), Nonzero::free), Error);
  EXPECT_EQ(grid, Grid(10, 5));
}

TEST(Grid, AMovedFromGridHasNoCells) {
  Grid from(100, 50);
  const Grid to = std::move(from);
  EXPECT_EQ(to.width(), 100);
  EXPECT_EQ(from.width(), 0);  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(from.height(), 0);
  EXPECT_FALSE(from.contains({0, 0}));
  EXPECT_TRUE(from.blocked({0, 0}));
  EXPECT_EQ(from.count_free(), 0);
  from = Grid(3, 3);
  EXPECT_EQ(from, Grid(3, 3));
}

}  // namespace
}  // namespace lasius
