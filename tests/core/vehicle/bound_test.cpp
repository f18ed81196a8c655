// Bounds of a vehicle's paths: what its headings at the ends come to, against drives and plans.
#include "core/vehicle/bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/vehicle/angle.h"
#include "core/vehicle/end_price.h"
#include "tests/core/vehicle/dense_check.h"
#include "tests/worlds/grids.h"

namespace lasius::vehicle {
namespace {

double unit(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

TEST(EndPrice, LateByWorkedByHand) {
  // Aside of the heading, forwards: it turns until 8 (1 - cos a) are done.
  EXPECT_NEAR(late_by(8, kPi / 2, 2, false), 8 * std::acos(0.75) - 2, 1e-12);
  // It heads there after 8 pi / 2, having done 8.
  EXPECT_NEAR(late_by(8, kPi / 2, 20, false), 8 * kPi / 2 - 8, 1e-12);
  EXPECT_NEAR(late_by(8, kPi / 2, 20, true), 8 * kPi / 2 - 8, 1e-12);
  // Behind, forwards: half a turn brings it nowhere.
  EXPECT_NEAR(late_by(8, kPi, 5, false), 8 * kPi, 1e-12);
  EXPECT_EQ(late_by(8, 0, 5, true), 0);
}

// Random drives end somewhere: none is shorter than where it ends lets it be.
TEST(EndPrice, NoDriveIsSooner) {
  constexpr double kRadius = 3;
  std::mt19937_64 random(5);
  double nearest = 1;
  for (int i = 0; i < 300000; ++i) {
    const bool reverse = i % 2 == 0;
    Pose at{};
    double length = 0;
    for (int piece = 0; piece < 1 + static_cast<int>(random() % 4); ++piece) {
      Segment s{.begin = at};
      s.curvature = (static_cast<double>(random() % 3) - 1) / kRadius;
      s.length = unit(random) * 2 * kRadius;
      s.gear = reverse && random() % 2 == 0 ? -1 : 1;
      at = s.end();
      length += s.length;
    }
    const double far = std::sqrt(at.x * at.x + at.y * at.y);
    double angle = std::fabs(direction(at.y, at.x));
    if (reverse) angle = std::min(angle, kPi - angle);
    const double on = far * (i % 3 == 0 ? 1 : unit(random));
    const double late = length - far - late_by(kRadius, angle, on, reverse);
    ASSERT_GE(late, -1e-9) << far << " " << angle << " " << on;
    if (angle > 1) nearest = std::min(nearest, late);
  }
  EXPECT_LT(nearest, 0.1);
}

// A wall in front of it, which ends far to either side.
TEST(EndPrice, IsPaidWhereTheWayLeadsAside) {
  const Grid grid = walled(200, 200, {{30, 98, 140, 4}});
  const Vehicle reversing = car(rectangle(3, 3, 3), 8);
  Vehicle forward = reversing;
  forward.reverse = false;
  for (const Vehicle& vehicle : {reversing, forward}) {
    const Prices prices(grid, vehicle, nullptr);
    const Bound bound(grid, vehicle, prices);
    // Around the wall's left end: along the headings, aside of them or away from there.
    const double to = direction(38, -53), from = direction(38, 53);
    const auto least = [&](double start, double goal) {
      return bound.least({.start = {80, 60, start}, .goals = {{80, 140, goal}}});
    };
    const double along = least(to, from);
    // Two tangents to circles about its corners, what is between these, and the turns around them.
    const double turns = 2 * (std::acos(38 / std::sqrt(3944.0)) + std::asin(3 / std::sqrt(3944.0)));
    EXPECT_NEAR(along, 2 * std::sqrt(3944.0 - 9) + 4 + 3 * turns, 0.01);
    EXPECT_GT(least(to + kPi / 2, from), along + 3);
    EXPECT_GT(least(to + kPi / 2, from - kPi / 2), along + 6);
    for (const double away : {least(to + kPi, from), least(to, from + kPi)}) {
      if (vehicle.reverse) {
        EXPECT_NEAR(away, along, 1e-3);
      } else {
        EXPECT_GT(away, along + 20);
      }
    }
  }
}

// Of vehicles that fill the disc inside them, and reverse at the price of a length, paths come near
// to it; none is shorter.
TEST(VehicleBound, NoPathIsShorter) {
  int found = 0, raised = 0;
  for (int world = 0; world < 6; ++world) {
    const Grid grid = blobs(world, 40 + 10 * (world % 4));
    const double size = 1 + world % 3;
    std::vector<Point> round;
    for (int i = 0; i < 16; ++i) {
      const auto [sine, cosine] = kernels::sine_cosine(i * kPi / 8);
      round.push_back({size * cosine, size * sine});
    }
    Vehicle vehicle = car(round, 3 + 2.5 * (world % 4));
    vehicle.reverse = world % 2 == 0;
    vehicle.reverse_cost = 1;
    const Planner planner(grid, vehicle);
    const Prices prices(grid, vehicle, nullptr);
    const Bound bound(grid, vehicle, prices);
    Vehicle turning = vehicle;
    turning.rotate_in_place = true;
    const Bound of_disc(grid, turning, prices);
    std::mt19937_64 random(world);
    for (int i = 0; i < 8; ++i) {
      Request request = random_request(planner.space(), random);
      request.weight = 1;
      if (i % 4 == 0) request.heading_tolerance = 0.3;
      const Result result = planner.plan(request);
      if (result.goal < 0) continue;
      ++found;
      const double least = bound.least(request);
      ASSERT_LE(least, result.length * (1 + 1e-9)) << world << " " << i;
      EXPECT_GE(least, of_disc.least(request) * 0.998);
      EXPECT_NEAR(*result.lower_bound, least, 1e-6);
      raised += least > of_disc.least(request) + 0.5 ? 1 : 0;
    }
  }
  EXPECT_GT(found, 30);
  EXPECT_GT(raised, 10);
}

}  // namespace
}  // namespace lasius::vehicle
