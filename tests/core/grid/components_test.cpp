#include "core/grid/components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/core/base/counting_time.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

using Connectivity = Components::Connectivity;
constexpr Connectivity kBoth[] = {Connectivity::four, Connectivity::eight};

// A number per cell, equal where joined, by plain breadth-first search; 0 where blocked.
struct Labels {
  int width;
  std::vector<int> of;
  int count = 0;
  int at(Cell c) const { return of[c.y * width + c.x]; }
};

Labels labels_of(const Grid& grid, Connectivity connectivity) {
  Labels labels{grid.width(), std::vector<int>(grid.width() * grid.height(), 0)};
  const auto label = [&](Cell c) {
    if (grid.blocked(c) || labels.at(c) != 0) return false;
    labels.of[c.y * grid.width() + c.x] = labels.count;
    return true;
  };
  for (const Cell seed : cells_of(grid)) {
    if (grid.blocked(seed) || labels.at(seed) != 0) continue;
    ++labels.count;
    label(seed);
    flood(seed, connectivity == Connectivity::eight, [&](Cell, Cell to) { return label(to); });
  }
  return labels;
}

// All pairs of some cells: random ones, and some on and near the tiles' borders.
void expect_equal(const Grid& grid, const Components& components, Connectivity connectivity,
                  std::mt19937& random, int cells = 60) {
  const Labels labels = labels_of(grid, connectivity);
  EXPECT_EQ(components.count(), labels.count);
  std::vector<Cell> asked;
  for (int i = 0; i < cells; ++i) {
    Cell c = random_cell(grid, random);
    if (i % 3 == 1) c.x = std::min(c.x / 256 * 256 + random_in(0, 1, random), grid.width() - 1);
    if (i % 5 == 1) c.y = std::max(c.y / 256 * 256 - random_in(0, 1, random), 0);
    asked.push_back(c);
  }
  for (const Cell a : asked) {
    for (const Cell b : asked) {
      const bool joined = labels.at(a) != 0 && labels.at(a) == labels.at(b);
      ASSERT_EQ(components.connected(grid, a, b), joined)
          << a.x << ',' << a.y << " - " << b.x << ',' << b.y;
    }
  }
}

TEST(Components, EqualBreadthFirstSearchOnNoise) {
  std::mt19937 random(1);
  constexpr int kSides[] = {1, 2, 3, 64, 65, 200, 255, 256, 257, 300, 511, 513, 700};
  for (int round = 0; round < 40; ++round) {
    const Grid grid =
        random_grid(kSides[random() % 13], kSides[random() % 13], 5 + 5 * (round % 16), random);
    for (const auto connectivity : kBoth) {
      expect_equal(grid, Components(grid, connectivity), connectivity, random);
    }
  }
}

TEST(Components, EqualBreadthFirstSearchOnMadeMaps) {
  std::mt19937 random(2);
  const auto ring = [](int x, int y, int side) {
    return std::min({x, y, side - 1 - x, side - 1 - y});
  };
  const std::vector<Grid> grids{
      Grid(700, 600), grid_of(600, 600, [](int, int) { return true; }),
      grid_of(600, 600, [](int x, int y) { return (x + y) % 2 == 0; }),
      grid_of(600, 600, [](int x, int) { return x % 2 == 0; }),
      grid_of(600, 600, [](int, int y) { return y % 2 == 1; }),
      // Diagonal stripes, joined by diagonal steps only.
      grid_of(600, 600, [](int x, int y) { return (x + y) % 4 != 0; }),
      // Rings, with gaps at changing places (a spiral of a kind) and without.
      grid_of(601, 601, [&](int x, int y) { return ring(x, y, 601) % 2 == 1; }),
      grid_of(601, 601,
              [&](int x, int y) {
                const int r = ring(x, y, 601);
                return r % 2 == 1 && !(x == 300 && y == (r % 4 == 1 ? r : 600 - r));
              }),
      // A snake through all rows, and a comb.
      grid_of(600, 600, [](int x, int y) { return y % 2 == 1 && x != (y % 4 == 1 ? 0 : 599); }),
      grid_of(600, 600, [](int x, int y) { return y % 2 == 1 && x != 0; }),
      // A closed yard with closed rooms in it: nothing touches the border of the one tile.
      grid_of(250, 250,
              [&](int x, int y) { return ring(x, y, 250) == 0 || ring(x % 50, y % 50, 20) == 0; }),
      // Cells of 5 x 5 with walls between, some with a door.
      grid_of(600, 600, [&random](int x, int y) {
        return (x % 6 == 0 || y % 6 == 0) && !(random() % 9 == 0);
      })};
  for (Grid grid : grids) {
    for (int pass = 0; pass < 2; ++pass) {  // a map of one component is answered at once
      for (const auto connectivity : kBoth) {
        expect_equal(grid, Components(grid, connectivity), connectivity, random);
      }
      grid.fill({0, 0, 3, 3}, true);
      grid.set_blocked({1, 1}, false);
    }
  }
}

TEST(Components, JoinsDiagonallyAcrossTileCorners) {
  for (const bool rising : {false, true}) {
    // And a cell by itself, without which there would be one component by 8 neighbours.
    const Grid grid = grid_of(512, 512, [&](int x, int y) {
      return (rising ? x + y != 511 : x != y) && !(x == 255 && y == 100);
    });
    EXPECT_TRUE(Components(grid, Connectivity::eight)
                    .connected(grid, {rising ? 511 : 0, 0}, {rising ? 0 : 511, 511}));
    EXPECT_FALSE(Components(grid, Connectivity::four)
                     .connected(grid, {rising ? 511 : 0, 0}, {rising ? 510 : 1, 1}));
    EXPECT_EQ(Components(grid, Connectivity::eight).count(), 2);
    EXPECT_EQ(Components(grid, Connectivity::four).count(), 513);
  }
}

TEST(Components, BlockedAndOutsideCellsAreJoinedToNothing) {
  const Grid grid = with_blocked(10, 10, {{3, 3}});
  const Components components(grid, Connectivity::four);
  EXPECT_TRUE(components.connected(grid, {2, 2}, {2, 2}));
  EXPECT_FALSE(components.connected(grid, {3, 3}, {3, 3}));
  EXPECT_FALSE(components.connected(grid, {2, 2}, {3, 3}));
  EXPECT_FALSE(components.connected(grid, {2, 2}, {10, 3}));
  EXPECT_FALSE(components.connected(grid, {-1, 2}, {2, 2}));
}

TEST(Components, AnEditEqualsAFreshBuild) {
  std::mt19937 random(3);
  for (int round = 0; round < 12; ++round) {
    Grid grid = random_grid(random_in(200, 800, random), random_in(200, 800, random),
                            random_in(5, 60, random), random);
    for (const auto connectivity : kBoth) {
      Components components(grid, connectivity);
      for (int edit = 0; edit < 8; ++edit) {
        std::vector<Cell> changed;
        for (int i = random_in(0, 40, random); i >= 0; --i) {
          const Cell c = random_cell(grid, random);
          grid.set_blocked(c, grid.free(c));
          changed.push_back(c);
        }
        components = *components.updated(grid, changed, {});
        ASSERT_EQ(components, Components(grid, connectivity));
      }
      expect_equal(grid, components, connectivity, random, 20);
    }
  }
}

// A cell, a brush of a few cells on a tile's border or anywhere, or a wall; what it changes.
Rectangle random_edit(Grid& grid, std::mt19937& random) {
  constexpr int kLongest[] = {1, 4, 20, 700};
  Cell c = random_cell(grid, random);
  if (random() % 2 == 0) c.x = std::max(c.x / 256 * 256 - random_in(0, 1, random), 0);
  if (random() % 2 == 0) c.y = std::max(c.y / 256 * 256 - random_in(0, 1, random), 0);
  const int width = random_in(1, kLongest[random() % 4], random);
  const int height = width > 20 ? random_in(1, 2, random) : random_in(1, 20, random);
  const Rectangle part{c.x, c.y, std::min(width, grid.width() - c.x),
                       std::min(height, grid.height() - c.y)};
  grid.fill(part, random() % 2 == 0);
  return part;
}

TEST(Components, UpdatesEqualAFreshBuildAndBreadthFirstSearch) {
  std::mt19937 random(5);
  constexpr int kSides[] = {1, 200, 256, 257, 511, 513, 700, 1025, 1300};
  for (int round = 0; round < 24; ++round) {
    Grid grid = random_grid(kSides[random() % 9], kSides[random() % 9], 7 * (round % 9), random);
    for (const auto connectivity : kBoth) {
      Components components(grid, connectivity);
      for (int update = 0; update < 30; ++update) {
        std::vector<Rectangle> changed(1);  // an empty one
        for (int i = update % 4; i >= 0; --i) changed.push_back(random_edit(grid, random));
        ASSERT_TRUE(components.update(grid, changed));
        ASSERT_EQ(components, Components(grid, connectivity));
      }
      expect_equal(grid, components, connectivity, random, 30);
    }
  }
}

// A door in a wall right across the map: what an edit changes reaches up to the largest block.
TEST(Components, ADoorJoinsAndPartsHalvesOfTheMap) {
  for (const auto connectivity : kBoth) {
    for (const int wall : {700, 767, 768, 1024}) {
      Grid grid = walled(1600, 2000, {{wall, 0, 1, 2000}});
      Components components(grid, connectivity);
      EXPECT_EQ(components.count(), 2);
      for (const int y : {0, 255, 256, 1023, 1024, 1999}) {
        for (const bool open : {true, false}) {
          grid.set_blocked({wall, y}, !open);
          ASSERT_TRUE(components.update(grid, std::vector<Rectangle>{{wall, y, 1, 1}}));
          EXPECT_EQ(components.connected(grid, {0, 1999}, {1599, 0}), open);
          EXPECT_EQ(components.count(), open ? 1 : 2);
        }
      }
    }
  }
}

TEST(Components, AnUpdateThatWasStoppedIsDoneByTheNext) {
  std::mt19937 random(6);
  Grid grid = random_grid(1600, 1400, 40, random);
  Components components(grid, Connectivity::eight);
  int stops = 0;
  for (int polls = 0; polls < 12; ++polls) {
    std::vector<Rectangle> changed;
    for (int i = 0; i < 15; ++i) changed.push_back(random_edit(grid, random));
    const CountingTime time(polls);
    if (!components.update(grid, changed, time.is_up())) {
      ++stops;
      if (polls % 2 == 0) continue;  // two or more in a row
      ASSERT_TRUE(components.update(grid, {}));
    }
    ASSERT_EQ(components, Components(grid, Connectivity::eight));
    expect_equal(grid, components, Connectivity::eight, random, 10);
  }
  EXPECT_GT(stops, 2);
}

TEST(Components, PollWhileTheyAreLabelledAndJoined) {
  const CountingTime counted(1 << 30);
  EXPECT_TRUE(Components::make(Grid(2048, 2048), Connectivity::four, counted.is_up()));
  EXPECT_GE(counted.polls(), 2 * 64 / 8);  // of 64 tiles
}

TEST(Components, StaySmallOnTheWorstMaps) {
  std::mt19937 random(4);
  const std::vector<Grid> grids{
      grid_of(1024, 1024, [](int x, int y) { return (x + y) % 2 == 0; }),
      grid_of(1024, 1024, [](int x, int y) { return x % 2 == 0 && y % 2 == 0; }),
      grid_of(1024, 1024,
              [](int x, int y) {  // stripes that cross every border
                return x % 256 > 2 && x % 256 < 253 ? x % 2 == 0 || (y % 256 > 2 && y % 256 < 253)
                                                    : y % 2 == 0;
              }),
      random_grid(1024, 1024, 40, random), random_grid(1024, 1024, 50, random)};
  for (const Grid& grid : grids) {
    for (const auto connectivity : kBoth) {
      const std::int64_t bits = Components(grid, connectivity).bytes() * 8;
      EXPECT_LE(bits, 1024 * 1024 / 4);
    }
  }
}

}  // namespace
}  // namespace lasius
