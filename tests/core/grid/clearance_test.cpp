#include "lasius/grid/clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lasius/base/error.h"
#include "lasius/grid/generate.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/counting_time.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

// The definitions, cell by cell, of the least square of what `apart` makes of two cells' distance
// along an axis: the outside is looked at one cell deep.
template <class Apart>
std::int64_t least_square(const Grid& grid, Cell c, const Apart& apart) {
  std::int64_t best = std::numeric_limits<std::int64_t>::max();
  for (int y = -1; y <= grid.height(); ++y) {
    for (int x = -1; x <= grid.width(); ++x) {
      if (grid.free({x, y})) continue;
      const std::int64_t dx = std::max(0, apart(std::abs(x - c.x)));
      const std::int64_t dy = std::max(0, apart(std::abs(y - c.y)));
      best = std::min(best, dx * dx + dy * dy);
    }
  }
  return best;
}

std::int64_t squared_half_cells(const Grid& grid, Cell c) {
  return least_square(grid, c, [](int cells) { return 2 * cells - 1; });
}

std::vector<Grid> sample_grids() {
  std::vector<Grid> grids = {drawn({"."}),     drawn({"#"}),
                             drawn({"....."}), drawn({".", ".", "#", "."}),
                             Grid(70, 31),     Grid(3, 90)};
  for (const std::uint64_t seed : {1, 2, 3}) {
    grids.push_back(generate(MapKind::random, {66, 40, 0.002, seed}));
    grids.push_back(generate(MapKind::random, {45, 52, 0.02, seed}));
    grids.push_back(generate(MapKind::blobs, {80, 40, 0.2, seed}));
  }
  return grids;
}

TEST(Clearance, IsWorkedOutByHand) {
  const ClearanceField field =
      clearance(drawn({".......", ".......", "...#...", ".......", "......."}));
  EXPECT_EQ(field.width, 7);
  EXPECT_EQ(field.height, 5);
  EXPECT_EQ(field.at({3, 2}), 0);
  EXPECT_EQ(field.at({2, 2}), 0.5) << "beside the block";
  EXPECT_EQ(field.at({2, 1}), std::sqrt(2.0) / 2) << "at its corner";
  EXPECT_EQ(field.at({1, 2}), 1.5);
  EXPECT_EQ(field.at({0, 0}), 0.5) << "the outside is near";
  EXPECT_EQ(field.at({5, 1}), 1.5) << "the outside again";
}

TEST(Clearance, AgreesWithTheDefinition) {
  for (const Grid& grid : sample_grids()) {
    const ClearanceField field = clearance(grid);
    for (const Cell c : cells_of(grid)) {
      ASSERT_EQ(field.squared_half_cells[static_cast<std::size_t>(c.y) * grid.width() + c.x],
                squared_half_cells(grid, c))
          << grid.width() << 'x' << grid.height() << " at " << c.x << ',' << c.y;
    }
  }
}

TEST(Clearance, HoldsTheLargestValue) {
  const ClearanceField field = clearance(Grid(32768, 3));
  EXPECT_EQ(field.at({16000, 1}), 1.5);
  const Grid corner = walled(1500, 1500, {{1400, 0, 1, 1500}});
  EXPECT_EQ(clearance(corner).at({699, 750}), 699.5);
}

// From the cell's nearest point, in cells.
double squared_gap(const Grid& grid, Cell c) {
  return static_cast<double>(least_square(grid, c, [](int cells) { return cells - 1; }));
}

TEST(GrowObstacles, BlocksWhatHasAPointNearerThanTheRadius) {
  std::vector<double> radii = {0, 1e-300, 0.25, 0.7, 1.58, 3.3, 7.07, 12, 19.5, 40, 1e6, 1e300};
  for (const double squared : {1, 2, 4, 5, 9, 10, 13, 25})  // the least number that blocks, or not
    for (const double towards : {0.0, std::sqrt(squared), 9.0})
      radii.push_back(std::nextafter(std::sqrt(squared), towards));
  for (const Grid& grid : sample_grids()) {
    std::vector<double> gaps;
    for (const Cell c : cells_of(grid)) gaps.push_back(squared_gap(grid, c));
    for (const double radius : radii) {
      const Grid grown = grow_obstacles(grid, radius);
      std::size_t i = 0;
      for (const Cell c : cells_of(grid)) {
        const double gap = gaps[i++];
        const bool near = gap == 0 || std::fma(radius, radius, -gap) > 0;  // its sign is exact
        ASSERT_EQ(grown.blocked(c), grid.blocked(c) || (radius > 0 && near))
            << grid.width() << 'x' << grid.height() << " at " << c.x << ',' << c.y << ", "
            << radius;
      }
    }
  }
}

TEST(GrowObstacles, IsWorkedOutByHand) {
  const Grid grid = drawn(
      {".........", ".........", ".........", "....#....", ".........", ".........", "........."});
  EXPECT_EQ(grow_obstacles(grid, 0), grid);
  for (const double radius : {1e-9, 0.5, 1.0})
    EXPECT_EQ(grow_obstacles(grid, radius),
              drawn({"#########", "#.......#", "#..###..#", "#..###..#", "#..###..#", "#.......#",
                     "#########"}));
  EXPECT_EQ(grow_obstacles(grid, std::nextafter(1.0, 2)).count_free(), 0);
  EXPECT_EQ(grow_obstacles(grid, 100).count_free(), 0);
}

/// Joined with that radius, not with a hair more.
TEST(WidestRadius, IsTheLastWithWhichCellsAreJoined) {
  int joined = 0, apart = 0;
  for (const Grid& grid : sample_grids())
    for (const Corners corners : {Corners::forbid, Corners::allow}) {
      const auto widest = WidestRadius::make(grid, corners);
      const auto are_joined = [&](double radius, Cell a, Cell b) {
        const Planner planner(grid, Disc{radius});
        return planner.passable().free(a) && planner.passable().free(b) &&
               planner.connected(a, b, corners);
      };
      for (int i = 0; i < 12; ++i) {
        const Cell a{17 * i % grid.width(), 5 * i % grid.height()};
        const Cell b{(31 * i + 7) % grid.width(), (11 * i + 3) % grid.height()};
        const auto radius = widest->between(a, b);
        ++(radius ? joined : apart);
        EXPECT_EQ(radius, widest->between(b, a));
        EXPECT_EQ(radius.has_value(), are_joined(0, a, b));
        if (!radius) continue;
        EXPECT_TRUE(are_joined(*radius, a, b)) << *radius;
        EXPECT_FALSE(are_joined(*radius > 0 ? *radius + 1e-6 : 0.05, a, b)) << *radius;
      }
    }
  EXPECT_GT(joined, 100);
  EXPECT_GT(apart, 20);
}

TEST(WidestRadius, IsWorkedOutByHand) {
  // A door of one cell.
  const Grid grid = drawn({"....#....", "....#....", ".........", "....#....", "....#...."});
  EXPECT_EQ(WidestRadius::make(grid)->between({0, 2}, {8, 2}), 0.5);
  EXPECT_EQ(WidestRadius::make(grid)->between({1, 1}, {2, 2}), 1.5);
  EXPECT_EQ(WidestRadius::make(grid)->between({4, 0}, {0, 0}), std::nullopt);
  const Grid squeezed = drawn({".#", "#."});
  EXPECT_EQ(WidestRadius::make(squeezed)->between({0, 0}, {1, 1}), std::nullopt);
  EXPECT_EQ(WidestRadius::make(squeezed, Corners::allow)->between({0, 0}, {1, 1}), 0);
  EXPECT_FALSE(WidestRadius::make(Grid(900, 900), Corners::forbid, fired()));
  // Whenever time is up there is none.
  const CountingTime enough(1000);
  const Grid wide(300, 300);
  EXPECT_TRUE(WidestRadius::make(wide, Corners::forbid, enough.is_up()));
  for (int polls = 0; polls < enough.polls(); ++polls)
    EXPECT_FALSE(WidestRadius::make(wide, Corners::forbid, CountingTime(polls).is_up()));
}

TEST(NearestBlocked, IsASquareOrTheOutside) {
  Grid grid(9, 9);
  grid.set_blocked({4, 5}, true);
  const struct {
    Point at;
    double most, beside, distance;
    Cell cell;
  } cases[] = {
      {{2.5, 5.5}, 9, 0, 1.5, {4, 5}},      {{2.5, 5.5}, 9, 0.5, 1, {4, 5}},
      {{3, 4}, 9, 0, std::sqrt(2), {4, 5}}, {{0.25, 3.5}, 9, 0, 0.25, {-1, 3}},
      {{4.5, 5}, 9, 0, 0, {4, 5}},          {{2.5, 2.5}, 2, 0, 2, {}},
  };
  for (const auto& [at, most, beside, distance, cell] : cases) {
    const NearestBlocked found = nearest_blocked(grid, at, most, beside);
    EXPECT_EQ(found.distance, distance) << at.x << ' ' << at.y;
    EXPECT_EQ(found.cell, cell) << at.x << ' ' << at.y;
  }
}

TEST(GrowObstacles, RefusesBadRadii) {
  for (const double radius : {-0.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)grow_obstacles(Grid(3, 3), radius), Error) << radius;
  }
}

}  // namespace
}  // namespace lasius
