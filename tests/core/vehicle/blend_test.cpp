// Curvature that changes no faster than it may: clothoids against a fine sum, blended paths by the
// judge, what rests and what does not.
#include "core/vehicle/blend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/vehicle/angle.h"
#include "lasius/base/error.h"
#include "lasius/vehicle/planner.h"
#include "lasius/vehicle/profile.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/vehicle/dense_check.h"
#include "tests/oracle/vehicle/footprint_judge.h"
#include "tests/worlds/grids.h"

namespace lasius::vehicle {
namespace {

oracle::Motion told(const Segment& s) {
  return {s.begin.x, s.begin.y, s.begin.yaw, s.curvature,
          s.length,  s.gear,    s.angle,     s.curvature_rate};
}

TEST(VehicleBlend, ClothoidsAreTheIntegralOfTheirYaw) {
  for (const int gear : {1, -1}) {
    for (const double rate : {0.03, -0.2, 1e-6}) {
      const Segment s{.begin = {3, 4, 0.7},
                      .curvature = 0.1,
                      .curvature_rate = rate,
                      .length = 9,
                      .gear = gear};
      for (const double share : {0.1, 0.5, 1.0}) {
        const auto at = oracle::FootprintJudge::pose_at(told(s), share);
        const Pose pose = s.pose(9 * share);
        EXPECT_NEAR(pose.x, at[0], 1e-8);
        EXPECT_NEAR(pose.y, at[1], 1e-8);
        EXPECT_NEAR(pose.yaw, at[2], 1e-12);
      }
      EXPECT_DOUBLE_EQ(s.curvature_at(9), 0.1 + gear * rate * 9);
    }
  }
}

/// Radius 4 and full lock within 4 cells, unless it is said otherwise.
Vehicle slow_hand(double rate = 1 / 16.0) {
  Vehicle made = car(rectangle(1, 3, 1.2), 4);
  made.curvature_rate = rate;
  return made;
}

TEST(VehicleBlend, ATurnHasItsEndsAndNoJump) {
  const Space space(Grid(80, 80), slow_hand());
  const double radius = with_room(slow_hand()).turning_radius;
  EXPECT_DOUBLE_EQ(radius, 4.4);
  Poller poller(kGoesOn);
  for (const double angle : {0.3, 0.8, kPi / 2, 2.5, 4.0}) {
    for (const int gear : {1, -1}) {
      std::vector<Segment> path{{.begin = {40, 40, 1}, .length = 6, .gear = gear}};
      path.push_back({.begin = path[0].end(),
                      .curvature = -1 / radius,
                      .length = angle * radius,
                      .gear = gear});
      path.push_back({.begin = path[1].end(), .length = 6, .gear = gear});
      std::int64_t checked = 0;
      const std::vector<Segment> made = blended(space.impl(), slow_hand(), path, checked, poller);
      EXPECT_EQ(corners(path), 2);
      ASSERT_EQ(corners(made), 0) << angle;
      Pose at = path[0].begin;
      double most = 0;
      for (const Segment& s : made) {
        EXPECT_NEAR(s.begin.x, at.x, 1e-8);
        EXPECT_NEAR(s.begin.y, at.y, 1e-8);
        EXPECT_LE(std::fabs(s.curvature_rate), 1 / 16.0 + 1e-12);
        most = std::max(most, s.sharpest());
        at = s.end();
      }
      EXPECT_LE(most, 0.25 + 1e-12);
      EXPECT_NEAR(at.x, path[2].end().x, 1e-8);
      EXPECT_NEAR(at.y, path[2].end().y, 1e-8);
    }
  }
}

TEST(VehicleBlend, WhatHasNoRoomStays) {
  const Vehicle vehicle = slow_hand();
  const Space open(Grid(80, 80), vehicle);
  Poller poller(kGoesOn);
  std::int64_t checked = 0;
  // An arc between arcs that is too short to steer to and fro.
  std::vector<Segment> path{{.begin = {40, 40, 0}, .curvature = 1 / 6.0, .length = 1}};
  path.push_back({.begin = path[0].end(), .curvature = -1 / 6.0, .length = 1});
  EXPECT_EQ(blended(open.impl(), vehicle, path, checked, poller), path);
  // A corner that the arc passes and what is in its place does not.
  std::vector<Segment> turn{{.begin = {20, 20, 0}, .length = 10}};
  turn.push_back({.begin = turn[0].end(), .curvature = 1 / 6.0, .length = 6 * 0.4});
  turn.push_back({.begin = turn[1].end(), .length = 10});
  ASSERT_EQ(corners(blended(open.impl(), vehicle, turn, checked, poller)), 0);
  const Grid tight = walled(80, 80, {{28, 18, 1, 1}, {28, 21, 1, 1}});
  const Space narrow(tight, vehicle);
  EXPECT_EQ(blended(narrow.impl(), vehicle, turn, checked, poller), turn);
  // It rests there if it is to.
  const SpeedLimits limits{.speed = 2, .acceleration = 1, .braking = 1};
  SpeedLimits steady = limits;
  steady.steady_curvature = true;
  EXPECT_EQ(Profile(turn, steady).state(1, 0).speed, 0);
  EXPECT_GT(Profile(turn, limits).state(1, 0).speed, 1);
  EXPECT_THROW(Planner(Grid(20, 20), slow_hand(1e-5)), Error);
}

// A turn that has no room, and others that have: stopped early all corners stay, later some.
TEST(VehicleBlend, KeepsTheCornersThatAreLeftOnceStopped) {
  const Vehicle vehicle = slow_hand();
  const Grid grid = walled(120, 80, {{28, 28, 1, 1}, {28, 31, 1, 1}});
  std::vector<Segment> path{{.begin = {20, 30, 0}, .length = 10}};
  for (int i = 0; i < 6; ++i) {
    const double radius = i == 0 ? 6 : i % 2 == 0 ? 5 : -5;
    path.push_back({.begin = path.back().end(),
                    .curvature = 1 / radius,
                    .length = std::fabs(radius) * (i == 0 ? 0.4 : 0.8)});
    path.push_back({.begin = path.back().end(), .length = 10});
  }
  const Space space(grid, vehicle);
  int before = corners(path), some = 0;
  EXPECT_EQ(before, 12);
  for (int after = 0;; ++after) {
    const CountingTime time(after);
    const StopCondition stop = time.is_up();
    Poller poller(stop, 1);
    std::int64_t checked = 0;
    const std::vector<Segment> made = blended(space.impl(), vehicle, path, checked, poller);
    if (after == 0) {
      EXPECT_EQ(made, path);
    }
    EXPECT_LE(corners(made), before);
    before = corners(made);
    Pose at = path[0].begin;
    for (const Segment& s : made) {
      EXPECT_NEAR(s.begin.x, at.x, 1e-8);
      EXPECT_NEAR(s.begin.y, at.y, 1e-8);
      at = s.end();
    }
    EXPECT_NEAR(at.x, path.back().end().x, 1e-8);
    EXPECT_NEAR(at.y, path.back().end().y, 1e-8);
    if (!poller.stopped()) break;
    some += before < 12 && before > 2;
  }
  EXPECT_GE(some, 2);
  EXPECT_GT(before, 0);
  EXPECT_LE(before, 2);
}

TEST(VehicleBlend, PlansKeepTheRate) {
  const Grid grid = blobs(11, 20);
  const Vehicle vehicle = slow_hand(1 / 8.0);
  const Planner planner(grid, vehicle);
  std::mt19937_64 random(4);
  oracle::FootprintJudge judge(grid, vehicle.footprint);
  int found = 0, jumps = 0, joints = 0;
  for (int i = 0; i < 20; ++i) {
    const Request request = random_request(planner.space(), random);
    const Result result = planner.plan(request);
    if (result.goal < 0) continue;
    ++found;
    std::vector<oracle::Motion> motions;
    for (const Segment& s : result.segments) {
      motions.push_back(told(s));
      EXPECT_LE(std::fabs(s.curvature_rate), 1 / 8.0 + 1e-12);
      EXPECT_LE(s.sharpest(), 0.25 + 1e-12);
    }
    EXPECT_FALSE(judge.first_touch(motions).has_value());
    EXPECT_EQ(result.corners, corners(result.segments));
    EXPECT_LE(*result.lower_bound, result.length + 1e-9);
    EXPECT_EQ(planner.plan(request).segments, result.segments);
    jumps += result.corners;
    joints += static_cast<int>(result.segments.size());
  }
  EXPECT_GE(found, 18);
  EXPECT_LT(10 * jumps, joints);
}

}  // namespace
}  // namespace lasius::vehicle
