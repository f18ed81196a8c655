#include "core/grid/cell_set.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>

#include "lasius/grid/grid.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

TEST(CellSet, HoldsWhatWasAddedAndNothingElse) {
  std::mt19937 random(1);
  CellSet cells;
  EXPECT_FALSE(cells.has({0, 0}));
  for (const int side : {5, 60, 3000}) {
    cells.reset(10);  // far too few: it grows
    std::set<std::pair<int, int>> added;
    for (int i = 0; i < 3000; ++i) {
      const Cell c{random_in(0, side, random), random_in(0, side, random)};
      cells.add(c);
      added.insert({c.x, c.y});
    }
    std::size_t count = 0;
    for (const CellSet::Tile& tile : cells.tiles()) {
      for (int bit = 0; bit < 64; ++bit) {
        if ((tile.cells >> bit & 1) == 0) continue;
        ++count;
        EXPECT_TRUE(added.contains({tile.cell(bit).x, tile.cell(bit).y}));
      }
    }
    EXPECT_EQ(count, added.size());
    for (int i = 0; i < 3000; ++i) {
      const Cell c{random_in(-1, side + 1, random), random_in(-1, side + 1, random)};
      EXPECT_EQ(cells.has(c), added.contains({c.x, c.y})) << c.x << ',' << c.y;
    }
  }
}

TEST(CellSet, TouchesTheFourCornersOfACell) {
  CellSet cells;
  cells.reset(1);
  cells.add({8, 15});
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) {
      EXPECT_EQ(cells.touches(x, y), (x == 8 || x == 9) && (y == 15 || y == 16));
    }
  }
}

TEST(CellSet, ReachesTheEdgesOfTheLargestGrid) {
  CellSet cells;
  cells.reset(4);
  constexpr int kLast = Grid::kMaxSide - 1;
  for (const Cell c : {Cell{0, 0}, Cell{kLast, 0}, Cell{0, kLast}, Cell{kLast, kLast}}) {
    cells.add(c);
  }
  EXPECT_EQ(cells.tiles().size(), 4u);
  EXPECT_TRUE(cells.has({kLast, kLast}));
  EXPECT_TRUE(cells.touches(kLast + 1, kLast + 1));
  EXPECT_TRUE(cells.touches(0, 0));
  for (const Cell c : {Cell{-1, 0}, Cell{0, -1}, Cell{-1, -1}, Cell{kLast + 1, kLast}}) {
    EXPECT_FALSE(cells.has(c));
  }
}

}  // namespace
}  // namespace lasius
