// Speeds along a path: times worked by hand, and against a fine integration.
#include "lasius/vehicle/profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/vehicle/angle.h"
#include "lasius/base/error.h"

namespace lasius::vehicle {
namespace {

/// There and back, with a turn in place at the end.
std::vector<Segment> path() {
  std::vector<Segment> segments{{.begin = {5, 5, 0}, .length = 10}};
  segments.push_back({.begin = segments.back().end(), .curvature = 0.25, .length = 6});
  segments.push_back({.begin = segments.back().end(), .length = 3});
  segments.push_back({.begin = segments.back().end(), .curvature = 0.1, .length = 4, .gear = -1});
  segments.push_back({.begin = segments.back().end(), .gear = 0, .angle = -kPi / 2});
  return segments;
}

TEST(VehicleProfile, TimesWorkedByHand) {
  const auto line = [](double length, const SpeedLimits& limits) {
    return Profile({{.begin = {}, .length = length}}, limits).duration();
  };
  EXPECT_DOUBLE_EQ(line(10, {.speed = 2}), 5);
  // Up in 1 s over 1 cell, down in half a second over half a cell, 8.5 cells at 2.
  EXPECT_DOUBLE_EQ(line(10, {.speed = 2, .acceleration = 2, .braking = 4}), 1 + 4.25 + 0.5);
  // Never at full speed: v^2 / 2 + v^2 / 2 = 1.
  EXPECT_DOUBLE_EQ(line(1, {.speed = 2, .acceleration = 1, .braking = 1}), 2);
  // A quarter turn: sqrt(2 * 0.5) over a circle of 2.
  EXPECT_NEAR(Profile({{.begin = {}, .curvature = 0.5, .length = kPi}},
                      {.speed = 9, .lateral_acceleration = 0.5})
                  .duration(),
              kPi, 1e-12);
  EXPECT_DOUBLE_EQ(Profile({{.begin = {}, .gear = 0, .angle = -3}}, {.turn_rate = 1.5}).duration(),
                   2);
  // Up over both lines' first half and down, 2 s each; then the turn at its own rate, likewise.
  const Pose far{8, 0, 0};
  EXPECT_DOUBLE_EQ(
      Profile(
          {{.begin = {}, .length = 4},
           {.begin = {4, 0, 0}, .length = 4},
           {.begin = far, .gear = 0, .angle = 2}},
          {.speed = 9, .acceleration = 2, .braking = 2, .turn_rate = 9, .turn_acceleration = 0.5})
          .duration(),
      4 + 4);
  EXPECT_EQ(Profile({}, {}).duration(), 0);
  EXPECT_THROW(line(1, {.speed = 0}), Error);
  EXPECT_THROW(line(1, {.speed = INFINITY}), Error);
}

TEST(VehicleProfile, KeepsItsLimitsAndAddsUp) {
  const SpeedLimits limits{.speed = 3,
                           .reverse_speed = 1,
                           .acceleration = 1.5,
                           .braking = 2,
                           .lateral_acceleration = 1,
                           .turn_rate = 1,
                           .turn_acceleration = 2};
  const Profile profile(path(), limits);
  const std::vector<TimedPose> samples = profile.samples(0.001);
  double summed = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const TimedPose& a = samples[i - 1];
    const TimedPose& b = samples[i];
    ASSERT_GE(b.time, a.time);
    if (a.at.gear != b.at.gear) {
      ASSERT_EQ(a.speed, 0);
      ASSERT_EQ(b.speed, 0);
      ASSERT_EQ(a.time, b.time);
      continue;
    }
    const double most = b.at.gear == 0 ? 1 : b.at.gear < 0 ? 1 : 3;
    ASSERT_LE(b.speed, most + 1e-12);
    ASSERT_LE(b.speed * b.speed * std::fabs(b.at.curvature), 1 + 1e-12);
    const double up = b.at.gear == 0 ? 2 : 1.5;
    ASSERT_LE(b.speed - a.speed, up * (b.time - a.time) + 1e-9);
    ASSERT_LE(a.speed - b.speed, 2 * (b.time - a.time) + 1e-9);
    const double moved = a.at.segment == b.at.segment ? b.at.at - a.at.at : b.at.at;
    summed += 2 * moved / (a.speed + b.speed);
  }
  EXPECT_NEAR(summed, profile.duration(), 1e-3);
  EXPECT_NEAR(samples.back().time, profile.duration(), 1e-9);
  EXPECT_EQ(samples.front().speed, 0);
}

TEST(VehicleMotion, PosesStandTwiceAtCusps) {
  const std::vector<Segment> segments = path();
  EXPECT_EQ(cusps(segments), 1);
  EXPECT_DOUBLE_EQ(driven_length(segments), 23);
  EXPECT_DOUBLE_EQ(cost(car(rectangle(1, 1, 1), 4), segments), 19 + 8 + 1.5 * kPi);
  const std::vector<PathPose> told = poses(segments, 0.5);
  int twice = 0;
  for (std::size_t i = 1; i < told.size(); ++i) {
    const Pose& a = told[i - 1].pose;
    const Pose& b = told[i].pose;
    ASSERT_LE(std::hypot(a.x - b.x, a.y - b.y), 0.5 + 1e-9);
    if (std::hypot(a.x - b.x, a.y - b.y) < 1e-9 && a.yaw == b.yaw) {
      ++twice;
      ASSERT_NE(told[i - 1].gear, told[i].gear);
    }
  }
  EXPECT_EQ(twice, 2);
  // A quarter of a circle of 4 to the side to which yaw grows, and back along it.
  const Segment arc{.begin = {1, 2, 0}, .curvature = 0.25, .length = 2 * kPi};
  EXPECT_NEAR(arc.end().x, 5, 1e-12);
  EXPECT_NEAR(arc.end().y, 6, 1e-12);
  const Segment back{.begin = arc.end(), .curvature = 0.25, .length = 2 * kPi, .gear = -1};
  EXPECT_NEAR(back.end().x, 1, 1e-12);
  EXPECT_NEAR(back.end().yaw, 0, 1e-12);
}

}  // namespace
}  // namespace lasius::vehicle
