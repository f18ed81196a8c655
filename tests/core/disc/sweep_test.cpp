#include "core/disc/sweep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/core/disc/disc_worlds.h"
#include "tests/oracle/disc_paths.h"
#include "tests/oracle/near_clearance.h"

namespace lasius::disc {
namespace {

TEST(Sweep, MeetsWhatIsNearerToASegment) {
  std::mt19937 random(5);
  int clear = 0, met = 0;
  for (int round = 0; round < scaled(200); ++round) {
    const Grid grid = random_map(random_radius(3, random), random);
    const oracle::DiscPaths paths(grid, 1, oracle::DiscPaths::Lines::none);
    for (int i = 0; i < 40; ++i) {
      const int grain = i % 2 == 0 ? 2 : 1 << 16;
      const auto any = [&](int size) { return 1.0 * random_in(0, grain * size, random) / grain; };
      const Point a{any(grid.width()), any(grid.height())};
      Point b{any(grid.width()), any(grid.height())};
      if (i % 5 == 0) b = {a.x, b.y};
      if (i % 5 == 1) b = {b.x, a.y};
      if (i % 5 == 2) b = {b.x, std::min<double>(a.y + 1e-9, grid.height())};
      if (i % 7 == 0) b = a;
      const double nearest = paths.clearance(a, b);
      if (nearest < 1e-8) {
        EXPECT_FALSE(sweeps_clear(grid, a, b, 1e-6));
        continue;
      }
      EXPECT_TRUE(sweeps_clear(grid, a, b, nearest - 1e-9)) << nearest;
      EXPECT_FALSE(sweeps_clear(grid, a, b, nearest + 1e-9)) << nearest;
      const double radius = random_radius(4, random);
      EXPECT_EQ(sweeps_clear(grid, a, b, radius), nearest >= radius);
      ++(nearest >= radius ? clear : met);
    }
  }
  EXPECT_GT(clear, 500);
  EXPECT_GT(met, 500);
}

TEST(Sweep, MeetsWhatIsNearerToAnArc) {
  constexpr double kSlack = 1e-9;
  constexpr int kSamples = 600;
  std::mt19937 random(6);
  int clear = 0, met = 0;
  for (int round = 0; round < scaled(4000); ++round) {
    const double radius = random_radius(4, random);
    Grid grid(24, 24);
    const double x = random_in(6, 18, random), y = random_in(6, 18, random);
    const int quadrant = random_in(0, 3, random);
    // Around the whole quadrant ends keep what is beyond the middle of the arc.
    const bool whole = round % 2 == 0;
    const auto angle = [&] { return random_in(0, 16, random) / 32.0 * std::numbers::pi; };
    const double from = whole ? 0 : angle(), to = whole ? 0.5 * std::numbers::pi : angle();
    for (int n = whole ? 1 : random_in(1, 8, random); n > 0; --n) {
      const auto off = [&] { return 1.4 * radius * (0.6 + 0.1 * random_in(0, 4, random)); };
      const double right = off(), down = off();
      const Cell cell{static_cast<int>(quadrant & 1 ? x - right : x + right),
                      static_cast<int>(quadrant & 2 ? y - down : y + down)};
      grid.set_blocked(whole ? cell : Cell{random_in(5, 18, random), random_in(5, 18, random)},
                       true);
    }
    const auto at = [&](double turn) {
      const double across = radius * std::cos(turn), along = radius * std::sin(turn);
      return Point{x + (quadrant & 1 ? -across : across), y + (quadrant & 2 ? -along : along)};
    };
    const auto nearest = [&](double turn) {
      return oracle::near_clearance(grid, at(turn), at(turn), radius);
    };
    if (nearest(from) < radius - kSlack || nearest(to) < radius - kSlack) continue;
    double least = radius;
    for (int i = 0; i <= kSamples; ++i)
      least = std::min(least, nearest(from + (to - from) * i / kSamples));
    const bool holds = turns_clear(grid, {x, y}, at(from), at(to), radius, kSlack);
    if (least < radius - 3 * kSlack) {
      EXPECT_FALSE(holds);
    }
    if (!holds) {
      EXPECT_LT(least, radius);
    }
    ++(holds ? clear : met);
  }
  EXPECT_GT(clear, 500);
  EXPECT_GT(met, 50);
}

}  // namespace
}  // namespace lasius::disc
