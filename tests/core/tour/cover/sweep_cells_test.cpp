#include "core/tour/cover/sweep_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/tour/cover/near_ends.h"
#include "core/tour/cover/swath_order.h"
#include "core/tour/cover/swaths.h"
#include "lasius/grid/generate.h"
#include "tests/oracle/disc_paths.h"
#include "tests/worlds/grids.h"

namespace lasius::tour {
namespace {

TEST(ToolLines, HaveAllPlacesThatKeepTheRadius) {
  const Grid grid = generate(MapKind::blobs, {.width = 24, .height = 18, .seed = 3});
  std::vector<Stretch> places;
  int inside = 0;
  for (const double radius : {0.0, 0.4, 1.5}) {
    const oracle::DiscPaths judge(grid, radius, oracle::DiscPaths::Lines::none);
    const ToolLines lines(grid, radius);
    for (const Heading& heading : headings()) {
      const Stretch extent = lines.extent(heading);
      for (double c = extent.from + 0.37; c < extent.to; c += 1.9) {
        lines.on_line(heading, c, places);
        for (double t = -40; t < 40; t += 0.31) {
          const Point p = heading.at(t, c);
          if (p.x <= 0 || p.y <= 0 || p.x >= grid.width() || p.y >= grid.height()) continue;
          const double room = judge.clearance(p);
          const bool in = std::any_of(places.begin(), places.end(), [&](const Stretch& one) {
            return one.from <= t && t <= one.to;
          });
          inside += in;
          // Near the ends of stretches either will do.
          if (in) {
            EXPECT_GE(room, radius - 1e-9);
          } else {
            EXPECT_LE(room, radius + 0.02);
          }
        }
      }
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(SweepCells, PartAndJoinAroundAnObstacle) {
  const Grid grid = walled(20, 12, {{8, 4, 5, 3}});
  const StopCondition never;
  Poller poller(never);
  const auto cells = sweep_cells(ToolLines(grid, 0), headings()[0], 2, poller);
  ASSERT_EQ(cells.size(), 4u);  // above, left, right, below
  const double from[] = {0, 4, 4, 7}, to[] = {4, 7, 7, 12};
  for (int i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(cells[i].from, from[i]);
    EXPECT_DOUBLE_EQ(cells[i].to, to[i]);
    EXPECT_EQ(cells[i].wall_before, i == 0);
    EXPECT_EQ(cells[i].wall_behind, i == 3);
  }
  EXPECT_EQ(cells[1].slices.front().stretch.to, 8);
  EXPECT_EQ(cells[2].slices.front().stretch.from, 13);
  // Where the free space leaps there is a new one, too: a door in a wall.
  Grid doors = walled(20, 12, {{0, 6, 20, 1}});
  doors.set_blocked({3, 6}, false);
  const auto through = sweep_cells(ToolLines(doors, 0), headings()[0], 2, poller);
  ASSERT_EQ(through.size(), 3u);
  EXPECT_TRUE(through[0].wall_behind && through[2].wall_before);
  EXPECT_FALSE(through[1].wall_before || through[1].wall_behind);
  // A step as long as the width is no leap yet.
  const ToolLines step(walled(4, 12, {{0, 0, 2, 6}}), 0);
  EXPECT_EQ(sweep_cells(step, headings()[0], 2, poller).size(), 1u);
  EXPECT_EQ(sweep_cells(step, headings()[0], 1.9, poller).size(), 2u);
}

// A wall with a door: ends on both sides of it are far from each other.
TEST(NearEnds, AreLinkedAroundWhatIsBlocked) {
  const Grid grid = walled(21, 12, {{10, 0, 1, 11}});
  const ToolLines lines(grid, 0);
  const std::vector<Point> stops = {{1, 1}, {10, 1}, {11, 1}, {20, 1}, {3.5, 11}, {18, 11}};
  const std::vector<EndLink> links = near_ends(grid, lines, stops);
  const auto linked = [&](int a, int b) {
    const auto at = std::find_if(links.begin(), links.end(),
                                 [&](const EndLink& one) { return one.a == a && one.b == b; });
    return at == links.end() ? -1 : at->length;
  };
  EXPECT_LT(linked(1, 2), 0);
  EXPECT_GE(linked(1, 4), 11.9);  // straight
  EXPECT_GE(linked(2, 5), 12.2);
  EXPECT_LT(linked(0, 1), 0);  // the same swath's
  // Without the links the second swath would be next to the first's end.
  const SwathChain chain = chained(2, stops, links);
  std::vector<int> order = chain.order;
  EXPECT_TRUE(
      std::is_permutation(order.begin(), order.end(), std::vector{0, 1, 2, 3, 4, 5}.begin()));
  for (const int end : {0, 2})
    EXPECT_EQ(std::abs(std::find(order.begin(), order.end(), end) -
                       std::find(order.begin(), order.end(), end + 1)),
              1);
}

// Of swaths side by side in that order.
TEST(NearEnds, ChainToAndFro) {
  const Grid grid(30, 12);
  std::vector<Point> stops;
  for (int row = 0; row < 6; ++row) {
    stops.push_back({1, 1.0 + 2 * row});
    stops.push_back({29, 1.0 + 2 * row});
  }
  const std::vector<EndLink> links = near_ends(grid, ToolLines(grid, 0), stops);
  const SwathChain chain = chained(6, stops, links);
  EXPECT_DOUBLE_EQ(chain.length, 5 * 2 + 10);
  EXPECT_DOUBLE_EQ(chained(6, stops, {}).length, 5 * 2 + 10);  // by straight ways alone
  EXPECT_EQ(chained(0, {}, {}).length, 0);
}

// The third swath is linked to an end that is joined by then: it is reached along the second.
TEST(NearEnds, ChainAlongSwaths) {
  const std::vector<Point> stops{{0, 0}, {10, 0}, {11, 0}, {21, 0}, {11, 5}, {21, 5}};
  const std::vector<EndLink> links{{1, 2, 1}, {2, 4, 5}};
  EXPECT_DOUBLE_EQ(chained(3, stops, links).length, 1 + (10 + 5) + std::hypot(21, 5));
}

TEST(WaysBetween, ReachFromEachEndToTheNearestOfAnotherSwath) {
  const std::vector<Swath> swaths{{{0, 0}, {10, 0}}, {{1, 0}, {12, 0}}};
  EXPECT_EQ(ways_between(swaths), (1 + 1 + 2 + 2) / 2.0);
  EXPECT_EQ(ways_between(swaths, true), (1 + 1) / 2.0);
  EXPECT_EQ(ways_between({swaths[0]}), 0);
}

TEST(SwathOrder, KeepsTheEndsOfASwathTogether) {
  const std::vector<Cost> matrix(49, 5);
  const SwathPricer swaths(3, Costs(7, matrix.data()));
  EXPECT_TRUE(swaths.joined(0, 1) && swaths.joined(5, 4));
  EXPECT_FALSE(swaths.joined(1, 2) || swaths.joined(6, 6));
  using Order = std::vector<int>;
  EXPECT_EQ(whole_swaths({1, 3, 2, 5, 4, 6, 0}, swaths, false), (Order{3, 2, 5, 4, 6, 0, 1}));
  EXPECT_EQ(whole_swaths({6, 1, 0, 3, 2, 5, 4}, swaths, true), (Order{6, 1, 0, 3, 2, 5, 4}));
  EXPECT_EQ(whole_swaths({6, 1, 3, 0, 2, 5, 4}, swaths, false), (Order{6, 1, 0, 3, 2, 5, 4}));
}

}  // namespace
}  // namespace lasius::tour
