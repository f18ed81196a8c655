// What a way tells from step to step, and where one is found though none is known.
#include <gtest/gtest.h>

#include <cmath>

#include "lasius/base/error.h"
#include "lasius/drive/drive.h"
#include "lasius/drive/navigator.h"
#include "lasius/path/path.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/counting_time.h"
#include "tests/worlds/changing_world.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

TEST(NavigatorWay, IsWhatIsLeftFromTheRobotOn) {
  int kept = 0;
  for (const char* name : {"exact", "fan2004", "acs", "grid-ga"}) {
    for (std::uint64_t seed = 1; seed <= (std::string(name) == "exact" ? 30 : 3); ++seed) {
      const Grid map = blobs(90, 60, seed);
      const Planner planner(map);
      const Request ends = far_apart(planner);
      Params params = quick(name);
      Navigator navigator(map, ends.goal, {.params = params});
      Cell robot = ends.start;
      double before = 1e9;
      for (int moves = 0; robot != ends.goal && moves < 500; ++moves) {
        const Way& way = navigator.step(robot);
        ASSERT_GT(way.walk.size(), 1u) << name << seed;
        EXPECT_EQ(way.path.front(), centre(robot));
        EXPECT_EQ(way.path.back(), centre(ends.goal));
        EXPECT_EQ(path_fault(map, way.path, navigator.corners()), std::nullopt);
        EXPECT_EQ(way.length, path_length(way.path));
        EXPECT_LE(way.length, before + 1.5);
        EXPECT_TRUE(way.replanned || !way.optimal);
        if (!way.replanned && std::string(name) == "exact") {
          // Where the robot is beside the path, another side may be shorter by a hair.
          const double best = planner.plan({robot, ends.goal}).length;
          EXPECT_GE(way.length, best * (1 - 1e-12));
          EXPECT_LE(way.length, best + 1.5);
          ++kept;
        }
        before = way.length;
        robot = way.walk[1 + static_cast<std::size_t>(moves) %
                                 std::min<std::size_t>(3, way.walk.size() - 1)];
      }
      EXPECT_EQ(robot, ends.goal);
      EXPECT_EQ(navigator.step(robot).length, 0);
    }
  }
  EXPECT_GT(kept, 500);
}

/// A corridor, the only way between two rooms.
Grid two_rooms() {
  Grid map = walled(41, 21, {{20, 0, 1, 21}});
  map.set_blocked({20, 10}, false);
  return map;
}

TEST(NavigatorWay, WallsThatAreNotSeenAgainAreDoubted) {
  const Rectangle mover{20, 9, 1, 3};
  Navigator navigator(two_rooms(), {35, 10});
  EXPECT_EQ(navigator.step({5, 10}).status, Status::solved);
  navigator.observe(mover, true);
  for (int step = 0; step < 16; ++step) {
    const Way& none = navigator.step({5, 10});
    EXPECT_EQ(none.status, Status::unreachable) << step;
    EXPECT_EQ(none.doubted, 0);
  }
  const Way& way = navigator.step({5, 10});
  EXPECT_EQ(way.status, Status::solved);
  EXPECT_EQ(way.doubted, 1);  // the map's own walls are not doubted
  EXPECT_TRUE(way.replanned);
  EXPECT_TRUE(navigator.map().blocked({20, 9}));
  EXPECT_EQ(navigator.step({5, 10}).doubted, 0);
}

TEST(NavigatorWay, WallsThatAreSeenAgainOrNeverDoubtedStay) {
  for (const bool seen : {true, false}) {
    Navigator navigator(two_rooms(), {35, 10}, {.doubt_after = seen ? 5 : 0});
    for (int step = 0; step < 30; ++step) {
      if (seen || step == 0) navigator.observe(std::vector<Cell>{{20, 10}, {-3, 99}}, true);
      EXPECT_EQ(navigator.step({5, 10}).status, Status::unreachable);
    }
  }
  EXPECT_THROW(Navigator(Grid(3, 3), {0, 0}, {.doubt_after = -1}), Error);
}

TEST(NavigatorWay, LeadsOutOfWhereTheRobotMayNotBe) {
  for (const char* name : {"exact", "acs"}) {
    const Grid map = walled(60, 30, {{20, 0, 2, 20}});
    Navigator navigator(map, {50, 5}, {.params = quick(name), .radius = 3});
    Cell robot{18, 10};  // too near to the wall
    ASSERT_TRUE(navigator.passable().blocked(robot));
    const Way& first = navigator.step(robot);
    ASSERT_EQ(first.way_out, (Point{16.5, 10.5})) << first.error;
    EXPECT_EQ(first.status, Status::solved);
    EXPECT_EQ(first.path.front(), centre(robot));
    EXPECT_FALSE(first.optimal);
    EXPECT_TRUE(first.curve.empty());
    EXPECT_NEAR(first.length, path_length(first.path), 1e-9);
    int plans = 0;
    for (int moves = 0; robot != navigator.goal() && moves < 200; ++moves) {
      const Way& way = navigator.step(robot);
      plans += way.replanned;
      EXPECT_EQ(way.way_out.has_value(), robot.x > 16 && moves < 2);
      EXPECT_EQ(way.path.front(), centre(robot));
      ASSERT_GT(way.walk.size(), 1u) << name;
      robot = way.walk[1];
      EXPECT_TRUE(navigator.passable().free(robot) || moves == 0);
    }
    EXPECT_EQ(robot, navigator.goal());
    EXPECT_EQ(plans, 0) << "the first one holds";
  }
}

TEST(NavigatorWay, AWayOutThatWasStoppedIsLookedForAgain) {
  const Grid map = walled(60, 30, {{20, 0, 2, 20}});
  Navigator navigator(map, {50, 5}, {.params = quick("acs"), .radius = 3, .goal_tolerance = 1});
  EXPECT_TRUE(navigator.step({18, 10}, fired()).path.empty());
  EXPECT_EQ(navigator.step({18, 10}).way_out, (Point{16.5, 10.5}));
}

TEST(NavigatorWay, AWayOutThatIsShutIsFoundAnew) {
  Navigator navigator(Grid(30, 30), {25, 25}, {.radius = 4});
  EXPECT_EQ(navigator.step({15, 1}).way_out, (Point{15.5, 4.5}));
  navigator.observe(std::vector<Cell>{{15, 2}}, true);
  const Way& way = navigator.step({15, 1});
  EXPECT_TRUE(way.replanned);
  ASSERT_TRUE(way.way_out.has_value());
  for (const Cell c : way.walk) EXPECT_TRUE(navigator.map().free(c));
  // Shut in, the answer is what it was.
  for (const Cell c : cells_of(Rectangle{13, 0, 5, 4}))
    if (c != Cell{15, 1}) navigator.observe(std::vector<Cell>{c}, true);
  EXPECT_EQ(navigator.step({15, 1}).fault, Fault::start_blocked);
}

TEST(NavigatorWay, EndsNearAGoalThatIsBlockedForAWhile) {
  for (const char* name : {"exact", "acs"}) {
    Navigator navigator(Grid(40, 20), {30, 10}, {.params = quick(name), .goal_tolerance = 4});
    EXPECT_EQ(navigator.step({5, 10}).goal_reached, (Cell{30, 10}));
    navigator.observe(Rectangle{29, 9, 3, 3}, true);
    const Way& way = navigator.step({5, 10});
    EXPECT_EQ(way.status, Status::solved);
    EXPECT_EQ(way.goal_reached, (Cell{30, 8}));
    EXPECT_EQ(way.path.back(), centre({30, 8}));
    navigator.observe(Rectangle{29, 9, 3, 3}, false);
    EXPECT_EQ(navigator.step({5, 10}).path.back(), centre({30, 10})) << name;
  }
}

TEST(NavigatorWay, ADriveArrivesWithinTheTolerance) {
  Grid truth = walled(40, 20, {{27, 7, 7, 7}});
  truth.fill({28, 8, 5, 5}, false);  // the goal is shut in, which the map has not
  const Cell goal{30, 10};
  const auto driven = [&](double tolerance, const Grid& map) {
    return drive(map, truth, {5, 10}, goal, {}, {.sense = 8}, {.goal_tolerance = tolerance});
  };
  for (const Grid& map : {Grid(40, 20), truth}) {
    const DriveResult near = driven(4, map), far = driven(3.9, map);
    EXPECT_EQ(near.status, Status::solved) << near.error;
    EXPECT_EQ(near.goal_reached, near.track.back());
    EXPECT_EQ(std::hypot(near.track.back().x - 30, near.track.back().y - 10), 4);
    EXPECT_EQ(far.status, Status::unreachable);
    EXPECT_EQ(far.goal_reached, std::nullopt);
  }
  truth.set_blocked(goal);
  EXPECT_EQ(driven(4, truth).status, Status::solved);
  const DriveResult refused = driven(3.9, truth);
  EXPECT_EQ(refused.fault, Fault::goal_blocked);
  EXPECT_EQ(refused.nearest_free, (Cell{30, 9}));
  EXPECT_EQ(refused.nearest_reachable, (Cell{30, 6}));
}

}  // namespace
}  // namespace lasius
