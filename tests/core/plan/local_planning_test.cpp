// A robot that sees only its eight neighbours, in a world where a door opens and shuts.
#include <gtest/gtest.h>

#include <vector>

#include "lasius/base/error.h"
#include "lasius/plan/planner.h"

namespace lasius {
namespace {

using Direction = Planner::Direction;

/// A wall at x = 10 with a door at y = 5 and a second gap far away, at y = 18.
struct World {
  World() : map(21, 20) {
    for (int y = 0; y < 20; ++y) map.set_blocked({10, y}, y != kDoor.y && y != 18);
  }
  /// The map does not know that the door is shut from tick 3 to 40.
  bool occupied(Cell c, int tick) const {
    return map.blocked(c) || (c == kDoor && tick >= 3 && tick < 40);
  }
  static constexpr Cell kDoor{10, 5};
  Grid map;
};

/// Directions out of `at` in which there is an obstacle that the map lacks.
std::vector<Direction> sensed(const World& world, Cell at, int tick) {
  std::vector<Direction> seen;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const Cell c{at.x + dx, at.y + dy};
      if (world.map.free(c) && world.occupied(c, tick)) seen.push_back({at, dx, dy});
    }
  }
  return seen;
}

Params ants() {
  Params p("lecture-grid");
  p.heuristic = Heuristic::goal_angle;
  p.visibility = Visibility::none;
  p.beta = 5;
  p.iterations = 20;
  p.threads = 1;
  return p;
}

/// Drives the robot, planning anew at every tick, and returns where it went.
std::vector<Cell> drive(const World& world, Cell from, Cell goal, int ticks) {
  Planner planner(world.map);
  std::vector<Cell> went{from};
  for (int tick = 0; tick < ticks && went.back() != goal; ++tick) {
    // Only what is reported now stays excluded.
    const auto before = planner.excluded();
    planner = *planner.allow(std::vector<Direction>(before.begin(), before.end()))
                   ->exclude(sensed(world, went.back(), tick));
    const Result way = planner.plan({.start = went.back(), .goal = goal}, ants());
    if (way.path.size() < 2) continue;  // waits
    const Cell next{static_cast<int>(way.path[1].x), static_cast<int>(way.path[1].y)};
    EXPECT_FALSE(world.occupied(next, tick)) << "tick " << tick;
    went.push_back(next);
  }
  return went;
}

TEST(LocalPlanning, ARobotNeverEntersWhatItSensesAndArrives) {
  const World world;
  const auto went = drive(world, {5, 5}, {16, 5}, 200);
  EXPECT_EQ(went.back(), (Cell{16, 5}));
  EXPECT_NE(std::find(went.begin(), went.end(), Cell{9, 5}), went.end()) << "never met the door";
}

TEST(LocalPlanning, ADirectionIsExcludedOnlyWhileItIsReported) {
  const World world;
  const Planner planner(world.map);
  const Request through{.start = {9, 5}, .goal = {11, 5}};
  const Direction east{{9, 5}, 1, 0};
  const Planner shut = *planner.exclude(std::vector{east});
  EXPECT_EQ(planner.plan(through).length, 2);
  EXPECT_GT(shut.plan(through).length, 26);  // by the other gap
  EXPECT_EQ(shut.allow(std::vector{east})->plan(through).length, 2);
  EXPECT_TRUE(shut.allow(std::vector{east})->excluded().empty());
}

TEST(LocalPlanning, ANeighbourReportedTwiceStaysShutUntilBothAreGone) {
  const World world;
  const Direction east{{9, 5}, 1, 0}, west{{11, 5}, -1, 0};
  const Planner both = *Planner(world.map).exclude(std::vector{east, west, east});
  EXPECT_EQ(both.excluded().size(), 2u);
  const Planner one = *both.allow(std::vector{east});
  EXPECT_TRUE(one.grid().blocked(World::kDoor));
  EXPECT_TRUE(one.allow(std::vector{west})->grid().free(World::kDoor));
}

TEST(LocalPlanning, WhatTheMapBlocksStaysBlocked) {
  const World world;
  const Direction wall{{9, 6}, 1, 0}, outside{{0, 0}, -1, -1};
  const Planner shut = *Planner(world.map).exclude(std::vector{wall, outside});
  EXPECT_TRUE(shut.allow(std::vector{wall, outside})->grid().blocked({10, 6}));
}

TEST(LocalPlanning, EditsAndExclusionsDoNotMixUp) {
  const World world;
  const Direction east{{9, 5}, 1, 0};
  const Planner shut = *Planner(world.map).exclude(std::vector{east});
  // Freed in the map, but still reported; blocked in the map, and no longer reported.
  EXPECT_TRUE(
      shut.edited(std::vector<Planner::Edit>{{World::kDoor, false}})->grid().blocked(World::kDoor));
  EXPECT_TRUE(shut.edited(std::vector<Planner::Edit>{{World::kDoor, true}})
                  ->allow(std::vector{east})
                  ->grid()
                  .blocked(World::kDoor));
}

TEST(LocalPlanning, BothWaysShutIsUnreachable) {
  const World world;
  const Planner shut =
      *Planner(world.map).exclude(std::vector<Direction>{{{9, 5}, 1, 0}, {{9, 18}, 1, 0}});
  EXPECT_EQ(shut.plan({.start = {5, 5}, .goal = {16, 5}}).status, Status::unreachable);
}

TEST(LocalPlanning, NamesWhatIsNoDirection) {
  const Planner planner{Grid(4, 4)};
  EXPECT_THROW((void)planner.exclude(std::vector<Direction>{{{4, 0}, 1, 0}}), Error);
  EXPECT_THROW((void)planner.exclude(std::vector<Direction>{{{1, 1}, 0, 0}}), Error);
  EXPECT_THROW((void)planner.exclude(std::vector<Direction>{{{1, 1}, 2, 0}}), Error);
  constexpr int kLeast = std::numeric_limits<int>::min();
  EXPECT_THROW((void)planner.exclude(std::vector<Direction>{{{1, 1}, kLeast, 1}}), Error);
}

}  // namespace
}  // namespace lasius
