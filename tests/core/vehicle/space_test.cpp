// Certified motions against a dense check that shares nothing with them: separating axes of the
// footprint's convex parts and of every blocked cell near, every 0.02 cells.
#include "lasius/vehicle/space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <string>

#include "lasius/base/error.h"
#include "tests/core/base/refusal.h"
#include "tests/core/vehicle/dense_check.h"
#include "tests/worlds/grids.h"

namespace lasius::vehicle {
namespace {

struct Shape {
  std::string name;
  std::vector<Point> footprint;
  std::vector<Part> parts;  // convex
};

std::vector<Shape> shapes() {
  const Part box = rectangle(6, 6, 4);
  const Part rear = rectangle(2, 10, 4);
  const Part kite{{-5, 0}, {0, -3}, {7, 0}, {0, 3}};
  const Part fork{{-4, -3}, {8, -3}, {8, -1.5}, {0, -1.5}, {0, 1.5}, {8, 1.5}, {8, 3}, {-4, 3}};
  return {{"box", box, {box}},
          {"rear axle", rear, {rear}},
          {"kite", kite, {kite}},
          {"fork",
           fork,
           {rectangle(4, 0, 3),
            {{0, -3}, {8, -3}, {8, -1.5}, {0, -1.5}},
            {{0, 1.5}, {8, 1.5}, {8, 3}, {0, 3}}}}};
}

Segment random_motion(std::mt19937_64& random) {
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const Pose begin{kSide * unit(), (kSide - 30) * unit(), 6.3 * unit()};
  if (random() % 8 == 0) return {.begin = begin, .gear = 0, .angle = 2 * unit() - 1};
  return {.begin = begin,
          .curvature = (static_cast<double>(random() % 3) - 1) / 8,
          .length = 10 * unit(),
          .gear = random() % 2 == 0 ? 1 : -1};
}

TEST(VehicleSpace, NoFalseFreeAndHardlyAFalseBlocked) {
  for (const Shape& shape : shapes()) {
    const Grid grid = blobs(7, 60);
    const Space space(grid, car(shape.footprint, 8));
    std::mt19937_64 random(5);
    int refused = 0;
    int free = 0;
    int motions = 0;
    for (int i = 0; i < 2500; ++i) {
      const Segment motion = random_motion(random);
      ASSERT_EQ(space.free(motion.begin), !touches(grid, shape.parts, motion.begin)) << i;
      if (!space.free(motion.begin)) continue;
      ++motions;
      const double step = motion.gear == 0 ? 0.003 : 0.02;
      bool touched = false;
      for (double at = 0; at <= motion.extent() && !touched; at += step) {
        touched = touches(grid, shape.parts, motion.pose(at));
      }
      const bool certified = space.free(motion);
      ASSERT_FALSE(certified && touched) << shape.name << " " << i;
      free += certified ? 1 : 0;
      refused += !certified && !touched ? 1 : 0;
      const std::optional<Contact> contact = space.first_contact(std::vector{motion});
      ASSERT_TRUE(!touched || contact.has_value());
      if (contact) {
        ASSERT_TRUE(grid.blocked(contact->cell));
        ASSERT_TRUE(contact->proven == touches(grid, shape.parts, contact->pose));
        // Nothing is touched before.
        for (double at = 0; at < contact->at - 0.01; at += step) {
          ASSERT_FALSE(touches(grid, shape.parts, motion.pose(at))) << i;
        }
      }
    }
    EXPECT_GT(free, 100) << shape.name;
    EXPECT_LE(refused, 3 + motions * 0.001) << shape.name;
  }
}

TEST(VehicleSpace, TouchingIsMeeting) {
  const Grid grid = with_blocked(40, 40, {{20, 20}});
  const Space space(grid, car(rectangle(2, 2, 1), 3));
  // The front edge lies on the cell's left side; then a hair before it.
  EXPECT_FALSE(space.free(Pose{18, 20.5, 0}));
  EXPECT_TRUE(space.free(Pose{18 - 1e-6, 20.5, 0}));
  // A hole is no part of the footprint; a cell wholly inside it is met.
  EXPECT_EQ(*space.contact(Pose{20.5, 20.5, 0.3}), (Cell{20, 20}));
  EXPECT_FALSE(space.free(Pose{1, 20, 0}));
  EXPECT_FALSE(space.free(Pose{1e300, 20, 0}));
  const Space fork(
      grid, car({{-4, -3}, {8, -3}, {8, -1.5}, {0, -1.5}, {0, 1.5}, {8, 1.5}, {8, 3}, {-4, 3}}, 8));
  EXPECT_TRUE(fork.free(Pose{17, 20.5, 0}));
  EXPECT_FALSE(fork.free(Pose{17, 22.5, 0}));
  EXPECT_FALSE(fork.free(Pose{22.5, 20.5, 0}));
}

TEST(VehicleSpace, PosesToldOneByOne) {
  const Grid grid = with_blocked(40, 40, {{20, 20}});
  const Space space(grid, car(rectangle(2, 2, 1), 3));
  const std::vector<Pose> past{{10, 10, 0}, {30, 10, 0}};
  const std::vector<Pose> through{{10, 10, 0}, {10, 20.5, 0}, {30, 20.5, 0}};
  EXPECT_FALSE(space.first_contact(past).has_value());
  const std::optional<Contact> contact = space.first_contact(through);
  ASSERT_TRUE(contact.has_value());
  EXPECT_EQ(contact->segment, 1);
  EXPECT_EQ(contact->cell, (Cell{20, 20}));
  EXPECT_NEAR(contact->pose.x, 18, 0.01);
}

// However far away the next pose is, the map is left where it ends: footprints reach 2 cells ahead.
TEST(VehicleSpace, PosesFarOutsideLeaveAtTheEdge) {
  const Grid grid(40, 40);
  const Space space(grid, car(rectangle(2, 2, 1), 3));
  for (const double far : {499000., 1e6, 1e300}) {
    const std::vector<Pose> out{{10, 10, 0}, {far, 10, 0}};
    const std::vector<Segment> straight{{.begin = out[0], .length = far, .gear = 1}};
    const auto of_poses = space.first_contact(out), of_motion = space.first_contact(straight);
    for (const auto& contact : {of_poses, of_motion}) {
      ASSERT_TRUE(contact.has_value());
      EXPECT_EQ(contact->cell.x, 40) << far;
      EXPECT_NEAR(contact->pose.x, 38, 0.01) << far;
    }
    EXPECT_NEAR(of_poses->at * far, 28, 0.02) << far;
    EXPECT_NEAR(of_motion->at, 28, 0.01) << far;
    // Of numbers that are none something is told, too.
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    for (const Segment& bad : {Segment{.begin = out[0], .length = kNone},
                               Segment{.begin = out[0], .length = far, .angle = kNone}})
      EXPECT_TRUE(space.first_contact(std::span(&bad, 1)).has_value());
  }
}

TEST(VehicleSpace, RefusesWhatIsNoVehicle) {
  const Grid grid(9, 9);
  const std::vector<Point> bow{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  Vehicle good = car(rectangle(1, 1, 1), 3);
  for (const auto& spoil : std::vector<void (*)(Vehicle&)>{
           [](Vehicle& v) {
             v.footprint.pop_back();
             v.footprint.pop_back();
           },
           [](Vehicle& v) { v.footprint[1].x = 5000; },
           [](Vehicle& v) { v.footprint[1] = v.footprint[0]; },
           [](Vehicle& v) { std::swap(v.footprint[1], v.footprint[2]); },
           [](Vehicle& v) { v.turning_radius = 0; }, [](Vehicle& v) { v.turning_radius = -1; },
           [](Vehicle& v) { v.reverse_cost = 0.5; }, [](Vehicle& v) { v.cusp_cost = std::nan(""); },
           [](Vehicle& v) { v.rotation_cost = 0; }}) {
    Vehicle bad = good;
    spoil(bad);
    EXPECT_THROW(Space(grid, bad), Error);
  }
  EXPECT_NO_THROW(Space(grid, good));
  const auto back = [&] { Space(grid, car({{-1, -1}, {3, -1}, {2, 1}, {0, 1}, {1, 1}}, 3)); };
  expect_says(refusal(back), "edge 3 of the footprint is gone back");
  EXPECT_DOUBLE_EQ(inscribed_radius(car(rectangle(2, 10, 4), 8)), 2);
  EXPECT_EQ(inscribed_radius(car({{1, -1}, {3, -1}, {3, 1}, {1, 1}}, 8)), 0);
}

}  // namespace
}  // namespace lasius::vehicle
