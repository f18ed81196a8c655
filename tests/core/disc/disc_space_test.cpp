#include "core/disc/disc_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/core/base/counting_time.h"
#include "tests/core/base/refusal.h"
#include "tests/core/disc/disc_worlds.h"
#include "tests/oracle/disc_paths.h"

namespace lasius::disc {
namespace {

Point random_point(const Grid& grid, std::mt19937& random) {
  const int grain = random_in(0, 1, random) == 0 ? 2 : 1 << 16;
  return {1.0 * random_in(0, grain * grid.width(), random) / grain,
          1.0 * random_in(0, grain * grid.height(), random) / grain};
}

// What cells say of their points, what points say of themselves, and straight moves.
TEST(DiscSpace, AgreesWithDistancesToAllSquares) {
  std::mt19937 random(2);
  int clear = 0, seen = 0, hidden = 0, band = 0;
  for (int round = 0; round < scaled(60); ++round) {
    const double radius = random_radius(round % 8 == 0 ? 8 : 2, random);
    const Grid grid = random_map(radius, random);
    const auto space = DiscSpace::make(grid, radius);
    const oracle::DiscPaths paths(grid, radius, oracle::DiscPaths::Lines::none);
    for (int i = 0; i < 200; ++i) {
      const Point p = random_point(grid, random);
      const Cell cell{std::min(static_cast<int>(p.x), grid.width() - 1),
                      std::min(static_cast<int>(p.y), grid.height() - 1)};
      ASSERT_NEAR(space->clearance(p, 9), std::min(9.0, paths.clearance(p)), 1e-12);
      ASSERT_EQ(space->clear(p), paths.clear(p));
      if (space->in_band(cell)) {
        ++band;
      } else {
        ASSERT_EQ(paths.clear(p), space->blocked_cells().free(cell));
      }
    }
    for (int i = 0; i < 60; ++i) {
      const auto a = random_clear(*space, random), b = random_clear(*space, random);
      if (!a || !b) continue;
      ++clear;
      const bool expected = paths.clearance(*a, *b) >= radius - kSlack;
      ASSERT_EQ(space->sees(*a, *b), expected) << round << ' ' << i;
      ++(expected ? seen : hidden);
      ASSERT_TRUE(!expected || space->joined(*a, *b));
    }
  }
  EXPECT_GT(seen, 200);
  EXPECT_GT(hidden, 200);
  EXPECT_GT(band, 500);
}

TEST(DiscSpace, IsOpenWhereItJustFits) {
  for (const double radius : {0.5, 1.0, 1.5, 3.0, 7.5}) {
    const int width = static_cast<int>(2 * radius);
    const Grid grid = grid_of(40, width + 20, [&](int x, int y) {
      return x >= 10 && x < 30 && (y < 10 || y >= 10 + width);
    });
    const Point a{4, 10 + radius}, b{36, 10 + radius};
    const auto fits = DiscSpace::make(grid, radius);
    if (radius <= 3) {
      EXPECT_TRUE(fits->sees(a, b)) << radius;
      EXPECT_TRUE(fits->joined(a, b));
      const auto wider = DiscSpace::make(grid, radius + 5e-7);
      EXPECT_FALSE(wider->joined(a, b)) << radius;
    } else {
      EXPECT_FALSE(fits->clear(a));  // the outside is too near
    }
  }
}

TEST(DiscSpace, ArcsOfOneBlock) {
  Grid grid(20, 20);
  grid.set_blocked({10, 10});
  const auto space = DiscSpace::make(grid, 2.0);
  ASSERT_EQ(space->arcs().size(), 4u);
  for (const Arc& arc : space->arcs()) {
    EXPECT_EQ(arc.low, 0);
    EXPECT_EQ(arc.high, 1);
  }
  EXPECT_NEAR(space->clearance({13, 14}, 9), std::hypot(2, 3), 1e-15);
  EXPECT_EQ(space->clearance({-1, 3}, 9), 0);
}

// Against samples each 0.1 cells. LASIUS_DISC_MAPS=25 asks of more than 2000 points.
TEST(DiscSpace, WayOutIsTheNearestClearPoint) {
  std::mt19937 random(3);
  int moved = 0, none = 0, led = 0, behind = 0;
  for (int round = 0; round < scaled(24); ++round) {
    const double radius = random_radius(3, random);
    const Grid grid = round % 8 == 7 ? random_grid(9, 9, 60, random) : random_map(radius, random);
    const auto space = DiscSpace::make(grid, radius);
    const oracle::DiscPaths paths(grid, radius, oracle::DiscPaths::Lines::none);
    for (int i = 0; i < 6; ++i) {
      const Point p = i < 2 ? random_point(grid, random) : centre(random_cell(grid, random));
      const double own = std::min(radius, paths.clearance(p));
      const auto leads_to = [&](Point to) { return paths.clearance(p, to) >= own - kSlack; };
      Poller poller(kNeverStops);
      const auto out = space->way_out(p, poller), by_leg = space->way_out(p, poller, {}, leads_to);
      double nearest = 1e9, nearest_led = 1e9;
      for (double y = 0; y <= grid.height(); y += 0.1) {
        for (double x = 0; x <= grid.width(); x += 0.1) {
          const double distance = std::hypot(x - p.x, y - p.y);
          if (distance >= nearest_led || !paths.clear({x, y})) continue;
          nearest = std::min(nearest, distance);
          if (leads_to({x, y})) nearest_led = distance;
        }
      }
      if (!out) {
        ++none;
        ASSERT_EQ(nearest, 1e9);
        continue;
      }
      ASSERT_TRUE(space->clear(*out));
      ASSERT_LE(std::hypot(out->x - p.x, out->y - p.y), nearest + 1e-9);
      moved += !(*out == p);
      behind += by_leg != out;
      if (own == 0) continue;
      if (!by_leg) {
        EXPECT_EQ(nearest_led, 1e9) << round << ' ' << i;
        continue;
      }
      ++led;
      ASSERT_TRUE(space->clear(*by_leg) && leads_to(*by_leg));
      EXPECT_LE(std::hypot(by_leg->x - p.x, by_leg->y - p.y), nearest_led + 1e-9)
          << round << ' ' << i;
    }
  }
  EXPECT_GT(moved, 50);
  EXPECT_GT(none, 0);
  EXPECT_GT(led, 50);
  EXPECT_GT(behind, 0);
}

// All that is asked of a space but the numbers of arcs.
void expect_same(const DiscSpace& one, const DiscSpace& other, std::mt19937& random) {
  ASSERT_EQ(one.map(), other.map());
  ASSERT_EQ(one.blocked_cells(), other.blocked_cells());
  ASSERT_EQ(one.crowded(), other.crowded());
  ASSERT_EQ(one.arc_cells(0), other.arc_cells(0));
  ASSERT_EQ(one.arc_cells(1), other.arc_cells(1));
  ASSERT_EQ(one.arcs().size(), other.arcs().size());
  std::vector<std::uint32_t> met(one.arcs().size(), ~0u);  // the other's number of each arc
  for (const Cell c : cells_of(one.map())) {
    ASSERT_EQ(one.in_band(c), other.in_band(c));
    if (!one.in_band(c)) continue;
    const auto arcs = one.arcs_at(c.x, c.y), others = other.arcs_at(c.x, c.y);
    ASSERT_EQ(arcs.size(), others.size()) << c.x << ' ' << c.y;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      ASSERT_LT(arcs[i], one.arcs().size());
      ASSERT_EQ(one.arcs()[arcs[i]], other.arcs()[others[i]]);
      if (met[arcs[i]] == ~0u) met[arcs[i]] = others[i];
      ASSERT_EQ(met[arcs[i]], others[i]);
    }
  }
  for (int i = 0; i < 20; ++i) {
    const Point a = random_point(one.map(), random), b = random_point(one.map(), random);
    ASSERT_EQ(one.joined(a, b), other.joined(a, b));
    Poller poller(kNeverStops);
    ASSERT_EQ(one.way_out(a, poller), other.way_out(a, poller));
  }
}

TEST(DiscSpace, AnUpdatedOneIsAsAFreshOne) {
  std::mt19937 random(4);
  for (int round = 0; round < scaled(60); ++round) {
    const double radius = random_radius(round % 6 == 0 ? 7 : 2.5, random);
    const double size = 14 * radius + 20;
    const int width = static_cast<int>(size) + random_in(0, 90, random);
    const int height = static_cast<int>(size) + random_in(0, 90, random);
    const int share = random_in(0, 3, random) + (radius < 1 ? 15 : 0);
    Grid grid = random_grid(width, height, share, random);
    auto space = DiscSpace::make(grid, radius);
    for (int edit = 0; edit < 12; ++edit) {
      std::vector<Cell> cells;
      for (int parts = random_in(1, 3, random); parts > 0; --parts) {
        const Cell at = random_cell(grid, random);
        const int side = random_in(1, 10, random), change = random_in(0, 2, random);
        for (const Cell c : cells_of({at.x, at.y, side, random_in(1, 10, random)})) {
          const bool blocked = change == 2 ? random_in(0, 3, random) == 0 : change == 1;
          if (!grid.contains(c) || grid.blocked(c) == blocked) continue;
          grid.set_blocked(c, blocked);
          cells.push_back(c);
        }
      }
      ASSERT_TRUE(space->update(grid, cells));
      const auto fresh = DiscSpace::make(grid, radius);
      expect_same(*space, *fresh, random);
      if (HasFatalFailure()) FAIL() << "round " << round << ", edit " << edit << ", " << radius;
      // Half of a list may be waste, and a vector has room for twice as much.
      ASSERT_LT(space->bytes(), 4 * fresh->bytes() + 4096);
    }
  }
}

TEST(DiscSpace, RefusesRadiiOutOfRange) {
  const Grid grid(4, 4);
  for (const double radius : {0.0, 0.04, 54.1, -1.0, std::nan("")})
    expect_says(refusal([&] { DiscSpace::make(grid, radius); }), "0.05");
  Poller poller(kNeverStops);
  EXPECT_EQ(DiscSpace::make(grid, 54)->way_out({1, 1}, poller), std::nullopt);
  EXPECT_TRUE(DiscSpace::make(grid, 0.05)->clear({1, 1}));
}

TEST(DiscSpace, CanBeStopped) {
  const Grid grid = grid_of(500, 500, [](int x, int y) { return (x * y) % 7 == 3; });
  EXPECT_FALSE(DiscSpace::make(grid, 1.5, CountingTime(0).is_up()).has_value());
}

}  // namespace
}  // namespace lasius::disc
