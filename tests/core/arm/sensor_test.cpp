#include "lasius/arm/sensor.h"

#include <gtest/gtest.h>

#include <limits>

#include "lasius/arm/generate.h"
#include "lasius/arm/trajectory.h"
#include "lasius/base/error.h"
#include "tests/core/arm/robot/arms.h"
#include "tests/oracle/arm/fcl_judge.h"

namespace lasius::arm {
namespace {

TEST(SceneSensor, APositionByHand) {
  // The arm lies along x, 0.01 thick; the ball's surface is 0.05 - 0.03 - 0.01 = 0.01 away.
  const Robot robot = two_links();
  const Scene scene{"", {ball({0.3, 0.05, 0}, 0.03)}};
  const JointVector q = joints({0, 0});
  EXPECT_TRUE(SceneSensor(robot, scene, 0.0049).position_free(q));
  EXPECT_FALSE(SceneSensor(robot, scene, 0.0051).position_free(q));
  EXPECT_EQ(
      SceneSensor(robot, scene, 0.0051).contact(q),
      "link 1 and obstacle 1, 0.01 m apart (less than twice the clearance, 0.0102 m, counts as "
      "touching)");
  EXPECT_EQ(SceneSensor(robot, scene, 0.0049).contact(q), "");
  EXPECT_NEAR(SceneSensor(robot, scene).distance(q), 0.01, 1e-12);
  EXPECT_EQ(SceneSensor(robot, {"", {ball({0.3, 0.05, 0}, 0.045)}}).distance(q), 0);
}

TEST(SceneSensor, ADistanceAmongManyThings) {
  // The nearest of three, whichever comes first; what only stands still does not count.
  const Robot robot = two_links();
  const JointVector q = joints({0, 0});
  const Obstacle near = ball({0.3, 0.1, 0}, 0.03), far = ball({0.3, -0.4, 0}, 0.03);
  EXPECT_NEAR(SceneSensor(robot, {"", {far, near, far}}).distance(q), 0.06, 1e-12);
  EXPECT_NEAR(SceneSensor(robot, {"", {near, far}}).distance(q), 0.06, 1e-12);
  EXPECT_EQ(SceneSensor(robot, {}).distance(q), std::numeric_limits<double>::infinity());
  EXPECT_THROW(SceneSensor(robot, {}).distance(joints({0})), Error);
  const Robot three = shipped("planar3");
  EXPECT_EQ(SceneSensor(three, {}).distance(joints({0.0, 2.5, 1.9})), 0);  // it touches itself
}

TEST(SceneSensor, AMotionPastAThinThing) {
  // Free at both ends, a wire between them.
  const Robot robot = two_links();
  const Scene wire{"", {ball({0, 0.8, 0}, 0.001)}};
  const SceneSensor sensor(robot, wire);
  const JointVector left = joints({1.2, 0}), right = joints({2.0, 0}), back = joints({1.2, 0.9});
  EXPECT_TRUE(sensor.position_free(left));
  EXPECT_TRUE(sensor.position_free(right));
  EXPECT_FALSE(sensor.motion_free(left, right));
  EXPECT_FALSE(sensor.motion_free(right, left));
  EXPECT_TRUE(sensor.motion_free(left, back) ||
              !sensor.position_free(back));  // away from it, or into it
}

TEST(SceneSensor, LinksDoNotTouchEachOther) {
  const Robot robot = shipped("planar3");
  const SceneSensor sensor(robot, {});
  EXPECT_TRUE(sensor.position_free(joints({0.0, 0.0, 0.0})));
  EXPECT_FALSE(sensor.position_free(joints({0.0, 2.5, 1.9})));
  EXPECT_EQ(sensor.contact(joints({0.0, 2.5, 1.9})),
            "link 1 (after shoulder) and link 3 (after wrist)");
  Robot lenient = robot;
  lenient.may_touch = {{3, 1}};
  EXPECT_TRUE(SceneSensor(lenient, {}).position_free(joints({0.0, 2.5, 1.9})));
}

TEST(SceneSensor, WhatIsFreeKeepsItsDistanceByFcl) {
  // Straight motions between random positions: FCL measures 100 places on each free one.
  const Robot robot = shipped("industrial6");
  int free = 0, blocked = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Query a = generate_query(robot, {.seed = seed, .obstacles = 15, .wall = 0.5});
    const Query b = generate_query(robot, {.seed = seed + 100, .obstacles = 0});
    const SceneSensor sensor(robot, a.scene);
    const bool is_free = sensor.motion_free(a.start, b.start);
    (is_free ? free : blocked)++;
    const oracle::FclJudge judge(robot, a.scene);
    double nearest = 1e300;
    for (int k = 0; k < 200; ++k)
      nearest = std::min(nearest, judge.distance(a.start + k / 199.0 * (b.start - a.start)));
    if (is_free) {
      EXPECT_GE(nearest, sensor.clearance() - 1e-6) << seed;
    } else {
      EXPECT_LT(nearest, 2 * sensor.clearance() + 0.02) << seed;
    }
    EXPECT_LT((judge.tip(a.start) - tip_position(robot, a.start)).norm(), 1e-12);
    EXPECT_NEAR(sensor.distance(a.start), judge.distance(a.start), 1e-5) << seed;
  }
  EXPECT_GE(free, 2);
  EXPECT_GE(blocked, 2);
}

TEST(SceneSensor, MeshesLikeTheBoxTheyMake) {
  Obstacle box;
  box.pose.translation() = Eigen::Vector3d(0.5, 0.4, 0);
  box.size = {0.2, 0.2, 0.2};
  Obstacle mesh = mesh_of(cube(0.1));
  mesh.pose = box.pose;
  const Robot robot = two_links();
  const SceneSensor by_box(robot, {"", {box}}), by_mesh(robot, {"", {mesh}});
  int free = 0;
  for (double a = -1.5; a < 1.5; a += 0.05) {
    for (double b = -2.5; b < 2.5; b += 0.25) {
      const JointVector q = joints({a, b});
      EXPECT_EQ(by_box.position_free(q), by_mesh.position_free(q)) << a << " " << b;
      free += by_box.position_free(q);
    }
  }
  EXPECT_GT(free, 100);
  EXPECT_LT(free, 1150);
}

TEST(SceneSensor, RefusesBadScenesAndRobots) {
  const Robot robot = two_links();
  EXPECT_THROW(SceneSensor(robot, {}, 0), Error);
  EXPECT_THROW(SceneSensor(robot, {}, 0.9e-6), Error);
  EXPECT_EQ(SceneSensor(robot, {}, Sensor::kLeastClearance).clearance(), 1e-6);
  EXPECT_THROW(SceneSensor(robot, {"", {ball({0, 0, 0}, -1)}}), Error);
  Scene tilted{"", {ball({0, 0, 0}, 1)}};
  tilted.obstacles[0].pose(0, 0) = 2;
  EXPECT_THROW(SceneSensor(robot, tilted), Error);
  EXPECT_THROW(SceneSensor(Robot(), {}), Error);
}

}  // namespace
}  // namespace lasius::arm
