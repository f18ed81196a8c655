// Drives of vehicles: every tick judged by the oracle in the world as it was then.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lasius/error.h"
#include "lasius/vehicle/drive.h"
#include "tests/oracle/vehicle/footprint_judge.h"
#include "tests/oracle/vehicle/motions.h"

namespace lasius::vehicle {
namespace {

const std::vector<Point> kTruck = rectangle(1.2, 3.4, 1.3);

/// What a drive showed, tick by tick.
struct Watched {
  std::vector<Grid> worlds;
  DriveObserver observer() {
    return [this](const DriveTick& tick) { worlds.push_back(*tick.world); };
  }
};

/// Each move lies between its poses, is one that the vehicle can drive, and meets nothing in the
/// world at the tick that it begins in, nor what has come by the tick it ends in.
void judge_drive(const Vehicle& vehicle, const DriveResult& run, const Watched& watched) {
  ASSERT_EQ(run.poses.size(), run.track.size());
  std::size_t next = 0;
  double length = 0;
  for (std::size_t tick = 0; tick + 1 < run.poses.size(); ++tick) {
    const Pose& at = run.poses[tick];
    if (at == run.poses[tick + 1]) continue;
    ASSERT_LT(next, run.moves.size());
    const Segment& move = run.moves[next++];
    ASSERT_NEAR(move.begin.x, at.x, 1e-6);
    ASSERT_NEAR(move.begin.y, at.y, 1e-6);
    ASSERT_NEAR(std::remainder(move.begin.yaw - at.yaw, 2 * std::numbers::pi), 0, 1e-6);
    ASSERT_EQ(move.end(), run.poses[tick + 1]);
    ASSERT_LE(move.length, 1);
    ASSERT_LE(std::fabs(move.curvature) * vehicle.turning_radius, 1 + 1e-12);
    ASSERT_TRUE(move.gear > 0 || (move.gear < 0 ? vehicle.reverse : vehicle.rotate_in_place));
    length += move.length;
    const auto motion = oracle::motions_of(std::span(&move, 1));
    for (const std::size_t world : {tick, tick + 1}) {
      if (world >= watched.worlds.size()) continue;
      oracle::FootprintJudge there(watched.worlds[world], vehicle.footprint);
      ASSERT_FALSE(there.first_touch(motion)) << "tick " << tick;
    }
  }
  ASSERT_EQ(next, run.moves.size());
  ASSERT_NEAR(run.length, length, 1e-9);
}

/// Blocks of 10 x 10 cells, streets of 8 between them, some of them closed.
Grid streets() {
  Grid grid(116, 80);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 6; ++i) {
      const int x = 8 + 18 * i, y = 8 + 18 * j;
      grid.fill({x, y, std::min(10, 116 - x), std::min(10, 80 - y)}, true);
      if ((7 * i + 3 * j) % 4 == 0 && i < 5) grid.fill({x + 10, y + 4, 8, 2}, true);
      if ((5 * i + 2 * j) % 5 == 0 && j < 3) grid.fill({x + 4, y + 10, 2, 8}, true);
    }
  }
  return grid;
}

TEST(VehicleDrive, LearnsACityOnItsWay) {
  const Grid truth = streets();
  const Grid map(116, 80);  // all free
  const Pose start{5, 4, 0}, goal{94, 75, 0};
  Vehicle forward = car(kTruck, 3);
  forward.reverse = false;
  int arrived = 0;
  for (const Vehicle& vehicle : {car(kTruck, 3), forward, differential(kTruck), omni(kTruck)}) {
    Watched watched;
    const auto go = [&](const DriveObserver& observer) {
      return drive(map, truth, vehicle, start, {goal}, {}, {.sense = 12, .max_ticks = 1500}, {}, {},
                   observer);
    };
    const DriveResult run = go(watched.observer());
    judge_drive(vehicle, run, watched);
    if (HasFatalFailure()) return;
    EXPECT_GT(run.seen, 100);
    if (run.status != Status::solved) continue;
    ++arrived;
    EXPECT_NEAR(std::hypot(run.poses.back().x - goal.x, run.poses.back().y - goal.y), 0, 1e-6);
    const DriveResult again = go({});
    EXPECT_EQ(again.poses, run.poses);
    EXPECT_EQ(again.moves, run.moves);
  }
  EXPECT_GE(arrived, 3);
}

TEST(VehicleDrive, WhatWouldBlockItsSweepWaits) {
  const Grid empty(80, 40);
  const Vehicle vehicle = car(kTruck, 4);
  Changes changes;
  // Walls fall about it all the time, and one moves through its lane.
  for (int tick = 1; tick < 40; ++tick) changes.cells.push_back({tick, {4 + tick, 17, 3, 4}, true});
  changes.obstacles.push_back(
      {.width = 3, .height = 3, .speed = 0.5, .track = {{60, 2}, {60, 35}}});
  Watched watched;
  const DriveResult run = drive(empty, empty, vehicle, {5, 19, 0}, {{70, 19, 0}}, changes,
                                {.sense = 10, .max_ticks = 600}, {}, {}, watched.observer());
  judge_drive(vehicle, run, watched);
  EXPECT_GT(run.deferred_changes, 0);
  EXPECT_EQ(run.status, Status::solved) << run.error;
}

TEST(VehicleDrive, DoubtsWhatTheMapHasAndTruthHasNot) {
  Grid map(80, 40);
  map.fill({40, 0, 2, 40}, true);  // a wall that is not there
  const Grid truth(80, 40);
  const Vehicle vehicle = car(kTruck, 4);
  Watched watched;
  const DriveResult run = drive(map, truth, vehicle, {5, 20, 0}, {{70, 20, 0}}, {},
                                {.sense = 8, .max_ticks = 500}, {}, {}, watched.observer());
  EXPECT_EQ(run.status, Status::solved) << run.error;
  judge_drive(vehicle, run, watched);
}

TEST(VehicleDrive, EndsWhereNoWayIsLeft) {
  Grid truth(80, 40);
  truth.fill({40, 0, 2, 40}, true);
  const Vehicle vehicle = car(kTruck, 4);
  const Grid map(80, 40);
  const DriveResult run = drive(map, truth, vehicle, {5, 20, 0}, {{70, 20, 0}}, {}, {.sense = 60});
  EXPECT_EQ(run.status, Status::unreachable);
  EXPECT_EQ(run.fault, Fault::disconnected);
  // Bad ends.
  const auto status = [&](const Pose& from, const Pose& to) {
    return drive(truth, truth, vehicle, from, {to}).fault;
  };
  EXPECT_EQ(status({39, 20, 0}, {70, 20, 0}), Fault::start_blocked);
  EXPECT_EQ(status({-3, 20, 0}, {70, 20, 0}), Fault::start_outside);
  EXPECT_EQ(status({5, 20, 0}, {40, 20, 0}), Fault::goal_blocked);
  EXPECT_THROW((void)drive(Grid(9, 9), truth, vehicle, {5, 5, 0}, {{7, 7, 0}}), Error);
}

TEST(VehicleDrive, ADeadEndThatItCannotLeaveForwards) {
  // Sight ends at the mouth of a lane that is closed behind a bend, one way alone.
  Grid truth(60, 40);
  truth.fill({0, 0, 60, 40}, true);
  truth.fill({4, 17, 50, 6}, false);
  Vehicle forward = car(kTruck, 4);
  forward.reverse = false;
  const Grid map(60, 40);
  const DriveResult run =
      drive(map, truth, forward, {8, 20, 0}, {{30, 35, 1}}, {}, {.sense = 5, .max_ticks = 1000});
  EXPECT_TRUE(run.status == Status::no_path || run.status == Status::unreachable ||
              run.status == Status::invalid)
      << to_string(run.status);
  EXPECT_FALSE(run.error.empty());
}

}  // namespace
}  // namespace lasius::vehicle
