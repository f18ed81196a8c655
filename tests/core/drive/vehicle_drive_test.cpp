// Drives of vehicles: every tick judged by the oracle in the world as it was then.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "kernels/base/random_stream.h"
#include "lasius/base/error.h"
#include "lasius/vehicle/drive.h"
#include "tests/core/base/counting_time.h"
#include "tests/oracle/vehicle/footprint_judge.h"
#include "tests/oracle/vehicle/motions.h"
#include "tests/worlds/grids.h"

namespace lasius::vehicle {
namespace {

constexpr double kPi = std::numbers::pi;
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
      if (world > tick && watched.worlds[world] == watched.worlds[tick]) continue;  // it is judged
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
      return drive(map, truth, vehicle, start, {goal}, {},
                   {.sense = 12, .max_ticks = 1500, .observer = observer});
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
                                {.sense = 10, .max_ticks = 600, .observer = watched.observer()});
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
                                {.sense = 8, .max_ticks = 500, .observer = watched.observer()});
  EXPECT_EQ(run.status, Status::solved) << run.error;
  judge_drive(vehicle, run, watched);
}

TEST(VehicleDrive, EndsWhereNoWayIsLeft) {
  const Grid truth = walled(80, 40, {{40, 0, 2, 40}});
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

/// A room, and a lane from it that turns down and ends, 6 cells wide.
Grid room_and_lane() {
  Grid truth = walled(70, 50, {{0, 0, 70, 50}});
  truth.fill({0, 0, 26, 50}, false);
  truth.fill({26, 8, 30, 6}, false);
  truth.fill({50, 8, 6, 22}, false);
  return truth;
}

TEST(VehicleDrive, ADeadEndThatItCannotLeaveForwards) {
  // On the map the lane leads back to the room; that it ends shows behind the bend.
  const Grid truth = room_and_lane();
  Grid map = truth;
  map.fill({50, 30, 6, 12}, false);
  map.fill({26, 36, 30, 6}, false);
  Vehicle forward = car(kTruck, 4);
  forward.reverse = false;
  for (const Vehicle& vehicle : {forward, car(kTruck, 4)}) {
    Watched watched;
    const DriveResult run = drive(map, truth, vehicle, {32, 11, 0}, {{20, 39, kPi}}, {},
                                  {.sense = 5, .max_ticks = 1000, .observer = watched.observer()});
    judge_drive(vehicle, run, watched);
    if (HasFatalFailure()) return;
    if (vehicle.reverse) {
      EXPECT_EQ(run.status, Status::solved) << run.error;
      continue;
    }
    EXPECT_EQ(run.status, Status::no_path);  // a disc would get there
    EXPECT_EQ(run.fault, Fault::none);
    EXPECT_FALSE(run.error.empty());
    EXPECT_GT(run.poses.back().y, 14);  // beyond the bend
  }
}

// It learns of posts as it goes aside, tick after tick.
TEST(VehicleDrive, GoesAsideAroundWhatItLearnsOnTheWay) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Grid map = walled(80, 40, {{50, 0, 2, 40}});
    Grid truth = map;
    for (std::uint32_t i = 0; i < 14; ++i) {
      const auto words = kernels::random_words(seed, {i, 0, 0, 7});
      const Cell post{static_cast<int>(words[0] % 44) + 3, static_cast<int>(words[1] % 38) + 1};
      if (std::abs(post.x - 12) > 8 || std::abs(post.y - 20) > 5) truth.set_blocked(post);
    }
    Changes changes;
    changes.cells.push_back({96, {50, 10, 2, 20}, false});
    const Vehicle vehicle = car(kTruck, 4);
    Watched watched;
    const DriveResult run =
        drive(map, truth, vehicle, {12, 20, 0}, {{70, 20, 0}}, changes,
              {.sense = 8, .max_ticks = 500, .seed = seed, .observer = watched.observer()});
    judge_drive(vehicle, run, watched);
    if (HasFatalFailure()) return;
    EXPECT_GT(run.moves.size(), 60U);
    EXPECT_EQ(run.status, Status::solved) << run.error;
  }
}

/// Nose first into the lane's end, and out of it again, by what does not reverse: no turn fits. The
/// map has a wall before it that is not there.
struct NoWayBack {
  Grid truth = room_and_lane(), map = truth;
  Vehicle forward = car(kTruck, 4);
  NoWayBack() {
    map.fill({30, 0, 2, 50}, true);
    forward.reverse = false;
  }
  DriveResult drive(const Grid& world, const StopCondition& stop = {}) const {
    return vehicle::drive(map, world, forward, {10, 11, 0}, {{53, 26, -kPi / 2}}, {},
                          {.sense = 4, .stop = stop});
  }
};

// A wall of the map that is not there proves nothing, nor does the lattice.
TEST(VehicleDrive, OnlyWhatIsThereProvesThatThereIsNoWay) {
  const NoWayBack asked;
  const DriveResult run = asked.drive(asked.truth);
  EXPECT_EQ(run.status, Status::no_path);
  EXPECT_EQ(run.fault, Fault::none);
  Grid closed = asked.truth;
  closed.fill({40, 0, 2, 50}, true);
  EXPECT_EQ(asked.drive(closed).status, Status::unreachable);
}

TEST(VehicleDrive, AsksWhatIsThereWithItsTolerances) {
  Grid truth(80, 40);
  truth.fill({68, 14, 4, 12}, true);  // about the goal
  Grid map = truth;
  map.fill({40, 0, 2, 40}, true);  // a wall that is not there
  const Vehicle vehicle = car(kTruck, 4);
  Watched watched;
  const DriveResult run = drive(map, truth, vehicle, {5, 20, 0}, {{70, 20, 0}}, {},
                                {.sense = 8, .max_ticks = 500, .observer = watched.observer()},
                                {.goal_tolerance = 12, .heading_tolerance = kPi});
  EXPECT_EQ(run.status, Status::solved) << run.error;
  judge_drive(vehicle, run, watched);
}

// What is there is asked within the drive's time; what is stopped is no answer.
TEST(VehicleDrive, AsksWhatIsThereWithinItsTime) {
  const NoWayBack asked;
  const auto go = [&](const CountingTime& clock) {
    return asked.drive(asked.truth, clock.is_up()).status;
  };
  const CountingTime endless(1 << 30);
  ASSERT_EQ(go(endless), Status::no_path);
  EXPECT_EQ(go(CountingTime(endless.polls() - 1)), Status::limit);
}

TEST(VehicleDrive, RefusesEndsThatAreNoPlaces) {
  const Grid grid(40, 40);
  const Vehicle vehicle = car(kTruck, 4);
  const Pose good{20, 20, 0};
  const auto no_place = [&](const Pose& from, const Pose& to) {
    try {
      (void)drive(grid, grid, vehicle, from, {good, to});
    } catch (const Error& error) {
      return error.code() == ErrorCode::invalid_parameter;
    }
    return false;
  };
  for (const double bad : {std::nan(""), 1e300, -1e300, HUGE_VAL}) {
    for (const Pose& pose : {Pose{bad, 20, 0}, Pose{20, bad, 0}, Pose{20, 20, bad}}) {
      EXPECT_TRUE(no_place(pose, good));
      EXPECT_TRUE(no_place(good, pose));
    }
  }
}

}  // namespace
}  // namespace lasius::vehicle
