// Where a robot stands nearer than its radius, and the clearance that a leg keeps.
#include <gtest/gtest.h>

#include "lasius/plan/planner.h"
#include "tests/core/base/counting_time.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

TEST(DiscWayOut, IsLedOutOfWhereItMayNotStand) {
  Grid grid(30, 20);
  grid.fill({10, 0, 1, 15}, true);  // a wall with room on one side of its end
  grid.fill({12, 6, 1, 5}, true);   // and a shelf too near to it
  const Planner planner(grid, Disc{2.25});
  const Result beside = planner.plan({{8, 5}, {4, 5}});
  ASSERT_EQ(beside.status, Status::solved);
  EXPECT_NEAR(beside.way_out->x, 7.75, 1e-9);
  EXPECT_EQ(beside.way_out->y, 5.5);
  EXPECT_NEAR(beside.length, 0.75 + 3.25, 1e-9);
  // The side of the wall on which it stands, though the other one is the goal's.
  const Result around = planner.plan({{9, 5}, {25, 5}});
  ASSERT_TRUE(around.way_out) << around.error;
  EXPECT_NEAR(around.way_out->x, 7.75, 1e-9);
  EXPECT_GT(around.length, 20);
  // Between wall and shelf no straight leg keeps what it has, but along both.
  const Result between = planner.plan({{11, 7}, {25, 5}});
  ASSERT_TRUE(between.way_out) << between.error;
  EXPECT_NEAR(between.way_out->x, 11.5, 1e-9);
  // What it stands in is blocked, or has a bend.
  EXPECT_EQ(planner.plan({{10, 5}, {25, 5}}).fault, Fault::start_blocked);
  grid.fill({11, 3, 2, 1}, true);
  grid.fill({11, 12, 2, 1}, true);
  const Result shut = Planner(grid, Disc{2.25}).plan({{11, 7}, {25, 5}});
  EXPECT_EQ(shut.status, Status::invalid);
  EXPECT_EQ(shut.way_out, std::nullopt);
  EXPECT_EQ(shut.error.find("start (11, 7) is nearer to what is blocked than the radius of 2.25; "
                            "the nearest free cell"),
            0u)
      << shut.error;
  // From the goal it is no way out: with a tolerance the path ends at the nearest clear point.
  for (const double tolerance : {0.0, 0.7, 0.8}) {
    const Result at_wall =
        planner.plan({.start = {4, 5}, .goal = {8, 5}, .goal_tolerance = tolerance});
    EXPECT_EQ(at_wall.status, tolerance < 0.75 ? Status::invalid : Status::solved) << at_wall.error;
    if (tolerance < 0.75) continue;
    EXPECT_NEAR(at_wall.path.back().x, 7.75, 1e-9);
    EXPECT_EQ(at_wall.goal_reached, (Cell{7, 5}));
    EXPECT_TRUE(at_wall.optimal);
    EXPECT_NEAR(at_wall.length, 3.25, 1e-9);
  }
  Grid large(600, 600);
  for (const Cell c : cells_of({0, 0, 30, 20})) large.set_blocked(c, grid.blocked(c));
  const Result stopped =
      Planner(large, Disc{2.25}).plan({.start = {11, 7}, .goal = {300, 300}, .stop = fired()});
  EXPECT_EQ(stopped.status, Status::interrupted);
}

}  // namespace
}  // namespace lasius
