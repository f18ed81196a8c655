// Ends of plans: beside walls, turned often, with numbers beyond any map; and what a cut leaves.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/vehicle/angle.h"
#include "lasius/base/error.h"
#include "lasius/vehicle/planner.h"
#include "tests/core/base/counting_time.h"
#include "tests/oracle/vehicle/footprint_judge.h"

namespace lasius::vehicle {
namespace {

constexpr double kHuge = std::numeric_limits<double>::max();

struct Beside {
  std::string name;
  Vehicle vehicle;
  double side = 0;  // from the reference point to the wall beside it, without room
};

std::vector<Beside> vehicles() {
  Vehicle forward = car(rectangle(6, 6, 4), 8);
  forward.reverse = false;
  return {{"car", car(rectangle(6, 6, 4), 8), 4},
          {"forward", forward, 4},
          {"rear axle", car(rectangle(2, 10, 3.7), 8), 3.7},
          {"differential", differential(rectangle(5, 5, 3)), 3}};
}

std::vector<oracle::Motion> path_of(const Result& result) {
  std::vector<oracle::Motion> path;
  for (const Segment& s : result.segments)
    path.push_back({s.begin.x, s.begin.y, s.begin.yaw, s.curvature, s.length, s.gear, s.angle});
  return path;
}

// In an empty map a vehicle gets away from the border along which it stands, and to it.
TEST(VehicleEnds, BesideTheBorder) {
  const Grid grid(160, 120);
  for (const Beside& kind : vehicles()) {
    const Planner planner(grid, kind.vehicle);
    for (const double room : {0.49, 0.1, 0.05, 0.005}) {
      const Pose beside{60.3, kind.side + room, 0};
      const Pose inside{110.2, 60.7, 0.4};
      const Pose before{20.6, 70.1, -0.3};
      const Pose parked{105.3, beside.y, 0};
      for (const auto& [start, goal] : {std::pair(beside, inside), std::pair(before, parked)}) {
        const Result result = planner.plan({.start = start, .goals = {goal}});
        EXPECT_EQ(result.status, Status::solved) << kind.name << " " << room << " " << result.error;
        EXPECT_LT(result.cost, room < 0.1 ? 220 : 140) << kind.name << " " << room;
        EXPECT_FALSE(
            oracle::FootprintJudge(grid, kind.vehicle.footprint).first_touch(path_of(result)));
      }
      const Result along = planner.plan({.start = beside, .goals = {{100.1, beside.y, 0}}});
      EXPECT_EQ(along.status, Status::solved) << kind.name << " " << room;
      EXPECT_NEAR(along.length, 100.1 - 60.3, 1e-6) << kind.name << " " << room;
    }
  }
}

// It has room for motions of the lattice, but none of these is as gentle as it needs.
TEST(VehicleEnds, ALongVehicleWithSomeRoom) {
  const Grid grid(200, 140);
  const Vehicle truck = car(rectangle(12, 12, 8), 8);
  const Planner planner(grid, truck);
  const Pose beside{80.3, 8.6, 0}, inside{150.2, 80.7, 0.4};
  for (const auto& [start, goal] : {std::pair(beside, inside), std::pair(inside, beside)}) {
    const Result result = planner.plan({.start = start, .goals = {goal}});
    ASSERT_EQ(result.status, Status::solved) << result.error;
    EXPECT_FALSE(oracle::FootprintJudge(grid, truck.footprint).first_touch(path_of(result)));
  }
}

/// A room, and a corridor into it along an arc about (60, 35), whose headings and cells hardly any
/// motion of the lattice has; it `leads_on` to another room, or ends at the map's edge.
Grid bent_pocket(bool leads_on = false) {
  Grid grid(120, 90);
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x) {
      const double dx = x + 0.5 - 60, dy = y + 0.5 - 35;
      const bool in_room = x >= 60 && x < 118 && y >= 2 && y < 88;
      const bool in_corridor = dx <= 0.6 && std::fabs(std::hypot(dx, dy) - 40) <= 5;
      const bool in_other = leads_on && x >= 2 && x < 42 && y >= 2 && y < 32;
      grid.set_blocked({x, y}, !in_room && !in_corridor && !in_other);
    }
  return grid;
}

TEST(VehicleEnds, OutOfABentPocket) {
  const Grid grid = bent_pocket();
  Vehicle turning = car(rectangle(6, 6, 4), 8);
  turning.reverse = false;
  turning.rotate_in_place = true;
  const Pose deep{60 - 40 * std::sin(kPi / 3), 35 + 40 * std::cos(kPi / 3), kPi / 3};
  const Pose in_room{95.5, 40.5, 1};
  for (const Vehicle& vehicle : {car(rectangle(6, 6, 4), 8), turning}) {
    const Planner planner(grid, vehicle);
    const Pose inwards{deep.x, deep.y, deep.yaw - kPi};
    for (const auto& [start, goal] : {std::pair(deep, in_room), std::pair(in_room, inwards)}) {
      const Result result = planner.plan({.start = start, .goals = {goal}});
      ASSERT_EQ(result.status, Status::solved) << result.error;
      EXPECT_FALSE(oracle::FootprintJudge(grid, vehicle.footprint).first_touch(path_of(result)));
    }
  }
}

// Neither end is in the corridor that the lattice does not fit.
TEST(VehicleEnds, ThroughABentCorridor) {
  const Grid grid = bent_pocket(true);
  Vehicle turning = car(rectangle(6, 6, 4), 8);
  turning.reverse = false;
  turning.rotate_in_place = true;
  const Pose in_room{95.5, 40.5, 1}, in_other{20.5, 16.5, 2};
  for (const Vehicle& vehicle : {car(rectangle(6, 6, 4), 8), turning}) {
    const Planner planner(grid, vehicle);
    for (const auto& [start, goal] : {std::pair(in_other, in_room), std::pair(in_room, in_other)}) {
      const Result result = planner.plan({.start = start, .goals = {goal}});
      ASSERT_EQ(result.status, Status::solved) << result.error;
      EXPECT_FALSE(oracle::FootprintJudge(grid, vehicle.footprint).first_touch(path_of(result)));
    }
  }
}

TEST(VehicleEnds, TurnedOften) {
  Grid grid(90, 70);
  grid.fill({40, 0, 3, 40}, true);
  const Planner planner(grid, car(rectangle(3, 3, 2), 5));
  const Result once = planner.plan({.start = {20, 20, 0.3}, .goals = {{70, 20, -1}}});
  ASSERT_EQ(once.status, Status::solved);
  for (const double turns : {15000.0, -15000.0}) {
    const Pose start{20, 20, 0.3 + turns * kTurn};
    const Pose goal{70, 20, turns * kTurn - 1};
    const Result often = planner.plan({.start = start, .goals = {goal}});
    ASSERT_EQ(often.status, Status::solved);
    EXPECT_LE(std::fabs(often.segments[0].begin.yaw), kPi);
    EXPECT_NEAR(often.segments[0].begin.yaw, 0.3, 1e-10);
    EXPECT_NEAR(often.length, once.length, 1e-6);
  }
  const auto stand = [&](double yaw) {
    return planner.plan({.start = {20, 20, yaw}, .goals = {{20, 20, yaw}}}).status;
  };
  EXPECT_EQ(stand(1e5), Status::solved);
  EXPECT_THROW(stand(1e5 + 1e-9), Error);
  // To the last digit: 2 pi is 6.28318530717958647692...
  EXPECT_NEAR(half_turned(1e5), 3.10583623688121974, 1e-15);
  EXPECT_NEAR(kernels::sine_cosine(half_turned(1e5)).sine, kernels::sine_cosine(1e5).sine, 1e-15);
}

TEST(VehicleEnds, NumbersBeyondAnyMap) {
  const Space space(Grid(50, 40), car(rectangle(3, 3, 2), 5));
  for (const double far : {kHuge, -kHuge, 1e19, std::nan(""), HUGE_VAL}) {
    for (const Pose& pose : {Pose{far, 20, 0}, Pose{20, far, 0}, Pose{20, 20, far}}) {
      EXPECT_FALSE(space.free(pose));
      EXPECT_TRUE(space.contact(pose).has_value());
      for (const Segment& s : {Segment{.begin = pose, .curvature = 0.1, .length = 5},
                               Segment{.begin = pose, .gear = 0, .angle = 1}}) {
        EXPECT_FALSE(space.free(s));
        EXPECT_TRUE(space.first_contact(std::span(&s, 1)).has_value());
      }
      EXPECT_TRUE(space.first_contact(std::span(&pose, 1)).has_value());
    }
    const Segment long_one{.begin = {20, 20, 0}, .curvature = 0.2, .length = std::fabs(far)};
    EXPECT_FALSE(space.free(long_one));
    EXPECT_THROW(static_cast<void>(poses(std::span(&long_one, 1), 0.5)), Error);
  }
  const Segment s{.begin = {20, 20, 0}, .length = 5};
  for (const double spacing : {0.0, -1.0, std::nan(""), 1e-9})
    EXPECT_THROW(static_cast<void>(poses(std::span(&s, 1), spacing)), Error);
  // A footprint that is all length.
  const Vehicle needle = car({{-3, 0}, {3, -1e-13}, {3, 1e-13}}, 5);
  EXPECT_TRUE(Space(Grid(50, 40), needle).free(Pose{25.5, 20.5, 0}));
}

// The bound that a cut call could not make is made by the next one.
TEST(VehicleEnds, BoundAfterACut) {
  const Grid grid(300, 200);
  const Vehicle vehicle = car(rectangle(1, 2, 1), 4);
  const Request request{.start = {10, 100, 0}, .goals = {{295, 100, 1}}};
  const Result whole = Planner(grid, vehicle).plan(request);
  ASSERT_TRUE(whole.lower_bound);
  const CountingTime counted(1 << 30);
  Request cut = request;
  cut.stop = counted.is_up();
  static_cast<void>(Planner(grid, vehicle).plan(cut));
  for (int polls = 0; polls < counted.polls(); ++polls) {
    const Planner planner(grid, vehicle);
    const CountingTime time(polls);
    cut.stop = time.is_up();
    EXPECT_EQ(planner.plan(cut).status, Status::limit) << polls;
    EXPECT_EQ(planner.plan(request).lower_bound, whole.lower_bound) << polls;
  }
}

}  // namespace
}  // namespace lasius::vehicle
