// Plans of vehicles: ends, joints, curvature and a dense check of every pose; what is told where
// there is no path.
#include "lasius/vehicle/planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "core/vehicle/angle.h"
#include "lasius/base/error.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/vehicle/dense_check.h"
#include "tests/worlds/grids.h"

namespace lasius::vehicle {
namespace {

double off(const Pose& a, const Pose& b) {
  return std::max(
      {std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(half_turned(a.yaw - b.yaw))});
}

Pose random_free(const Space& space, std::mt19937_64& random) {
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (;;) {
    const Pose pose{kSide * unit(), (kSide - 30) * unit(), kTurn * unit()};
    if (space.free(pose)) return pose;
  }
}

void check(const Grid& grid, const Vehicle& vehicle, const std::vector<Part>& parts,
           const Request& request, const Result& result) {
  Pose at = request.start;
  for (const Segment& s : result.segments) {
    ASSERT_LE(off(s.begin, at), 1e-7);
    ASSERT_LE(std::fabs(s.curvature) * vehicle.turning_radius, 1 + 1e-12);
    ASSERT_TRUE(s.gear > 0 || (s.gear < 0 && vehicle.reverse) ||
                (s.gear == 0 && vehicle.rotate_in_place));
    ASSERT_TRUE(s.gear == 0 || s.angle == 0 || vehicle.sideways);
    const double step = s.gear == 0 ? 0.01 : 0.1;
    for (double share = 0; share <= s.extent(); share += step) {
      ASSERT_FALSE(touches(grid, parts, s.pose(share)));
    }
    at = s.end();
  }
  ASSERT_LE(off(at, request.goals[result.goal]), 1e-6);
  ASSERT_NEAR(result.cost, cost(vehicle, result.segments), 1e-9);
  ASSERT_EQ(result.cusps, cusps(result.segments));
  if (request.bound && result.lower_bound) {
    ASSERT_LE(*result.lower_bound, result.length + 1e-6);
  }
}

struct Kind {
  std::string name;
  Vehicle vehicle;
  std::vector<Part> parts;
  int least;  // found of 20
};

std::vector<Kind> kinds() {
  const Part box = rectangle(6, 6, 4);
  Vehicle forward = car(box, 8);
  forward.reverse = false;
  Vehicle turning = forward;
  turning.rotate_in_place = true;
  Vehicle priced = car(box, 8);
  priced.cusp_cost = 4;
  const Part rear = rectangle(1, 7, 2.5);
  return {{"reversing", car(box, 8), {box}, 18},
          {"forward", forward, {box}, 8},
          {"forward and in place", turning, {box}, 18},
          {"cusps priced", priced, {box}, 18},
          {"differential", differential(rear), {rear}, 18},
          {"omni", omni(rear), {rear}, 19},
          {"small", car(rectangle(0.4, 0.6, 0.4), 0.7), {rectangle(0.4, 0.6, 0.4)}, 19}};
}

TEST(VehiclePlanner, PathsTouchNothing) {
  const Grid grid = blobs(11, 25);
  for (const Kind& kind : kinds()) {
    const Planner planner(grid, kind.vehicle);
    std::mt19937_64 random(4);
    int found = 0;
    for (int i = 0; i < 20; ++i) {
      Request request{.start = random_free(planner.space(), random), .goals = {}};
      request.goals.push_back(random_free(planner.space(), random));
      const Result result = planner.plan(request);
      if (result.goal < 0) {
        ASSERT_TRUE(result.segments.empty());
        ASSERT_FALSE(result.error.empty());
        continue;
      }
      ++found;
      ASSERT_EQ(result.status, Status::solved);
      check(grid, kind.vehicle, kind.parts, request, result);
      if (HasFatalFailure()) FAIL() << kind.name << " " << i;
      const Result again = planner.plan(request);
      ASSERT_EQ(again.segments, result.segments);
    }
    EXPECT_GE(found, kind.least) << kind.name;
  }
}

// So hard that all of the lattice is looked at: forwards alone, among blocks.
TEST(VehiclePlanner, LooksAtAllOfTheLatticeWhereThatIsHard) {
  const Part box = rectangle(6, 6, 4);
  Vehicle forward = car(box, 8);
  forward.reverse = false;
  const Grid grid = blobs(2, 45);
  const Planner planner(grid, forward);
  std::mt19937_64 random(2);
  int hard = 0;
  for (int i = 0; i < 27; ++i) {
    Request request{.start = random_free(planner.space(), random), .goals = {}};
    request.goals.push_back(random_free(planner.space(), random));
    const Result result = planner.plan(request);
    if (result.expanded < 20000 || result.goal < 0) continue;
    ++hard;
    check(grid, forward, {box}, request, result);
    EXPECT_EQ(planner.plan(request).segments, result.segments);
  }
  EXPECT_EQ(hard, 2);
}

TEST(VehiclePlanner, DrivesToAnySide) {
  // A lane in which it cannot turn, and whose bend it takes aside.
  Grid grid = walled(60, 60, {{0, 0, 60, 60}});
  grid.fill({5, 5, 15, 50}, false);
  grid.fill({5, 45, 50, 10}, false);
  const Part box = rectangle(6, 6, 3.5);
  const Planner planner(grid, omni(box));
  const Request request{.start = {12.3, 10.2, 0}, .goals = {{48.1, 50.2, 0}}};
  const Result result = planner.plan(request);
  ASSERT_EQ(result.status, Status::solved) << result.error;
  check(grid, planner.space().vehicle(), {box}, request, result);
  for (const Segment& s : result.segments) EXPECT_EQ(s.begin.yaw, 0);
  EXPECT_GE(result.length, 35.8 + 39 - 9);
  EXPECT_LE(result.length, 35.8 + 40);
  EXPECT_EQ(Planner(grid, differential(box)).plan(request).status, Status::no_path);
  const Result open =
      Planner(Grid(60, 60), omni(box)).plan({.start = {20, 20, 0}, .goals = {{30, 40, 0.5}}});
  EXPECT_NEAR(open.length, std::sqrt(500.0), 1e-9);
  EXPECT_NEAR(open.cost, std::sqrt(500.0) + 0.5 * 3, 1e-9);
  Vehicle both = omni(box);
  both.turning_radius = 3;
  EXPECT_THROW(validate(both), Error);
  both = omni(box);
  both.reverse = true;
  EXPECT_THROW(validate(both), Error);
}

TEST(VehiclePlanner, RefusesRatesOfCurvatureOutOfRange) {
  for (const double radius : {0.0, 4.0}) {
    Vehicle vehicle = differential(rectangle(6, 6, 3.5));
    vehicle.turning_radius = radius;
    for (const double rate : {0.0, 0.1, 1e6}) {
      vehicle.curvature_rate = rate;
      EXPECT_NO_THROW(validate(vehicle));
    }
    for (const double rate : {-0.1, -1e-300, std::nan(""), 1e300, HUGE_VAL}) {
      vehicle.curvature_rate = rate;
      EXPECT_THROW(validate(vehicle), Error) << radius << ' ' << rate;
    }
  }
}

// A car of 128 cells: several words a row.
TEST(VehiclePlanner, LargeVehicle) {
  const Grid grid = walled(700, 420, {{340, 0, 20, 200}});
  const Part hull = rectangle(30, 98, 30);
  const Planner planner(grid, car(hull, 90));
  const Request request{.start = {60, 100, 1.2}, .goals = {{620, 110, -1.4}}};
  const Result result = planner.plan(request);
  ASSERT_EQ(result.status, Status::solved) << result.error;
  check(grid, planner.space().vehicle(), {hull}, request, result);
}

TEST(VehiclePlanner, SaysWhyNot) {
  Grid grid = walled(60, 40, {{29, 0, 2, 40}});
  const auto why = [&](const Pose& start, const Pose& goal) {
    return Planner(grid, car(rectangle(3, 3, 2), 4)).plan({.start = start, .goals = {goal}});
  };
  EXPECT_EQ(why({15, 20, 0}, {45, 20, 0}).status, Status::unreachable);
  EXPECT_EQ(why({27, 20, 0}, {45, 20, 0}).fault, Fault::start_blocked);
  EXPECT_EQ(*why({27, 20, 0}, {45, 20, 0}).touched, (Cell{29, 17}));
  EXPECT_EQ(why({15, 20, 0}, {45, 39, 0}).fault, Fault::goal_blocked);
  EXPECT_EQ(why({15, 20, 0}, {99, 39, 0}).fault, Fault::goal_outside);
  EXPECT_THROW(why({15, 20, 0}, {45, std::nan(""), 0}), Error);
  // A gap for the disc, which the vehicle cannot turn into, proves nothing.
  grid.fill({29, 18, 2, 5}, false);
  const Result narrow = Planner(grid, car(rectangle(6, 6, 2.6), 4))
                            .plan({.start = {15, 20, 1.57}, .goals = {{45, 20, 0}}});
  EXPECT_EQ(narrow.status, Status::unreachable);
  const Result wide =
      Planner(grid, car({{-6, -2.6}, {0, -2}, {6, -2.6}, {6, 2.6}, {0, 2}, {-6, 2.6}}, 4))
          .plan({.start = {15, 20, 1.57}, .goals = {{45, 20, 0}}});
  EXPECT_EQ(wide.status, Status::no_path);
  EXPECT_NE(wide.error.find("lattice"), std::string::npos);
}

TEST(VehiclePlanner, Stops) {
  const Grid grid = blobs(11, 25);
  const Planner planner(grid, car(rectangle(6, 6, 4), 8));
  std::mt19937_64 random(4);
  Request request{.start = random_free(planner.space(), random), .goals = {}};
  request.goals.push_back(random_free(planner.space(), random));
  request.stop = fired();
  EXPECT_EQ(planner.plan(request).status, Status::interrupted);
  request.stop = {.deadline = Clock::time_point::min()};
  EXPECT_EQ(planner.plan(request).status, Status::limit);
  EXPECT_FALSE(Planner::make(grid, planner.space().vehicle(), request.stop).has_value());
}

TEST(VehiclePlanner, TolerancesAndSeveralGoals) {
  const Grid grid(80, 80);
  const Planner planner(grid, car(rectangle(3, 3, 2), 6));
  const Pose start{20, 40, 0};
  const Result exact = planner.plan({.start = start, .goals = {{60, 40, kPi}}});
  const Result any_yaw =
      planner.plan({.start = start, .goals = {{60, 40, kPi}}, .heading_tolerance = kPi});
  ASSERT_EQ(any_yaw.status, Status::solved);
  EXPECT_NEAR(any_yaw.length, 40, 1e-6);
  EXPECT_GT(exact.length, 45);
  const Result near = planner.plan(
      {.start = start, .goals = {{60, 1, 0.3}}, .goal_tolerance = 3, .heading_tolerance = 0.4});
  ASSERT_EQ(near.status, Status::solved);
  const Pose end = near.segments.back().end();
  EXPECT_LE(std::hypot(end.x - 60, end.y - 1), 3 + 1e-9);
  EXPECT_LE(std::fabs(half_turned(end.yaw - 0.3)), 0.4);
  const Result anywhere = planner.plan(
      {.start = start, .goals = {{60, 1, kPi}}, .goal_tolerance = 200, .heading_tolerance = 0.4});
  ASSERT_EQ(anywhere.status, Status::solved);
  EXPECT_LE(std::fabs(half_turned(anywhere.segments.back().end().yaw - kPi)), 0.4);
  const Result two =
      planner.plan({.start = start, .goals = {{60, 40, kPi}, {70, 40, 0}, {-5, 3, 0}}});
  EXPECT_EQ(two.goal, 1);
}

TEST(Planner, IsThereAlready) {
  const Vehicle car{.footprint = {{-1, -0.8}, {3, -0.8}, {3, 0.8}, {-1, 0.8}}, .turning_radius = 4};
  const Planner planner(Grid(40, 30), car);
  for (const double yaw : {0.0, 2 * kPi}) {
    const Result there = planner.plan({.start = {10, 10, 0}, .goals = {{10, 10, yaw}}});
    EXPECT_EQ(there.status, Status::solved);
    EXPECT_EQ(there.length, 0);
    EXPECT_EQ(there.gap(), 0);
    ASSERT_EQ(there.segments.size(), 1u);
  }
  const Result near = planner.plan({.start = {10, 10, 0},
                                    .goals = {{10.5, 10, 0.1}},
                                    .goal_tolerance = 1,
                                    .heading_tolerance = 1});
  EXPECT_EQ(near.length, 0);
}

TEST(Planner, ToleratesGoalsThatAreBlockedOrBehindAWall) {
  const Vehicle car{.footprint = {{-1, -1}, {2, -1}, {2, 1}, {-1, 1}}, .turning_radius = 4};
  const Grid post = with_blocked(400, 60, {{370, 30}});
  const Result blocked = Planner(post, car).plan(
      {.start = {10.5, 30.5, 0}, .goals = {{370.5, 30.5, 0}}, .goal_tolerance = 3});
  EXPECT_NE(blocked.status, Status::limit);
  const Grid wall = walled(120, 80, {{60, 0, 1, 70}});
  const Result before = Planner(wall, car).plan(
      {.start = {30.5, 10.5, 0}, .goals = {{64.5, 10.5, 0}}, .goal_tolerance = 9});
  ASSERT_EQ(before.status, Status::solved);
  EXPECT_LE(*before.lower_bound, before.length);
}

TEST(Planner, TakesVehiclesThatHardlyTurn) {
  const Vehicle train{.footprint = {{-1, -1}, {2, -1}, {2, 1}, {-1, 1}}, .turning_radius = 1e5};
  const Planner planner(Grid(60, 30), train);
  const Result ahead = planner.plan({.start = {10, 15, 0}, .goals = {{50, 15, 0}}});
  EXPECT_EQ(ahead.status, Status::solved);
  EXPECT_NEAR(ahead.length, 40, 1e-6);
  Vehicle slow = train;
  slow.curvature_rate = 1e-6;  // for which there is room within the largest radius
  EXPECT_EQ(Planner(Grid(60, 30), slow).plan({.start = {10, 15, 0}, .goals = {{50, 15, 0}}}).status,
            Status::solved);
}

TEST(Planner, TellsOfEveryCut) {
  const Vehicle car{.footprint = {{-1, -1}, {2, -1}, {2, 1}, {-1, 1}}, .turning_radius = 4};
  Grid grid(300, 200);
  for (int x = 20; x < 290; x += 30) grid.fill({x, x % 60 == 20 ? 0 : 20, 2, 180}, true);
  const Planner planner(grid, car);
  Request request{.start = {10, 100, 0}, .goals = {{295, 100, 0}}};
  const CountingTime counted(1 << 30);
  request.stop = counted.is_up();
  const Result whole = planner.plan(request);
  ASSERT_EQ(whole.status, Status::solved);
  ASSERT_GT(counted.polls(), 3);
  int cut = 0;
  for (int polls = 0; polls < counted.polls(); ++polls) {
    const CountingTime time(polls);
    request.stop = time.is_up();
    const Result result = planner.plan(request);
    cut += result.status == Status::limit;
    if (result.status == Status::solved) {
      EXPECT_EQ(result.length, whole.length) << polls;
      EXPECT_EQ(result.lower_bound, whole.lower_bound) << polls;
    }
  }
  EXPECT_GT(cut, 2);
}

}  // namespace
}  // namespace lasius::vehicle
