#include "core/arm/robot/kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/arm/robot/vec3.h"
#include "lasius/arm/sensor.h"
#include "lasius/base/error.h"
#include "tests/core/arm/robot/arms.h"
#include "tests/core/base/refusal.h"

namespace lasius::arm {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

TEST(Kinematics, TwoLinksByHand) {
  const Robot robot = two_links();
  const auto expect_tip = [&](std::initializer_list<double> q, Vec3 tip) {
    EXPECT_LT(distance(tip_position(robot, joints(q)), tip), 1e-15) << joints(q).transpose();
  };
  expect_tip({0, 0}, {0.9, 0, 0});
  expect_tip({kQuarter, 0}, {0, 0.9, 0});
  expect_tip({0, kQuarter}, {0.5, 0.4, 0});
  expect_tip({kQuarter, -kQuarter}, {0.4, 0.5, 0});
  expect_tip({1e6, 0}, {0.9 * std::cos(1e6), 0.9 * std::sin(1e6), 0});
}

TEST(Kinematics, APrismaticJointAndATurnedFrameByHand) {
  Robot robot;
  Joint slide;
  slide.kind = Joint::Kind::prismatic;
  slide.frame = to_eigen({roll_pitch_yaw({0, 0, kQuarter}), {1, 0, 0}});  // its x is the world's y
  slide.axis = {1, 0, 0};
  slide.high = 2;
  robot.joints = {slide};
  robot.tip.translation().x() = 0.5;
  EXPECT_LT(distance(tip_position(robot, joints({0.0})), {1, 0.5, 0}), 1e-15);
  EXPECT_LT(distance(tip_position(robot, joints({2.0})), {1, 2.5, 0}), 1e-15);
  const Pose tip = tip_pose(robot, joints({2.0}));
  EXPECT_EQ(tip.translation(), tip_position(robot, joints({2.0})));
  EXPECT_LT((tip.linear() * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-15);
}

TEST(Kinematics, LinksMoveWithTheirJoints) {
  const auto placed = place_links(two_links(), joints({kQuarter, -kQuarter}));
  ASSERT_EQ(placed.size(), 2u);
  const Solid &upper = placed[0].solids[0], &lower = placed[1].solids[0];
  EXPECT_LT(distance(upper.pose * upper.size, {0, 0.5, 0}), 1e-15);
  EXPECT_LT(distance(from_eigen(lower.pose).position, {0, 0.5, 0}), 1e-15);
  EXPECT_LT(distance(lower.pose * lower.size, {0.4, 0.5, 0}), 1e-15);
}

TEST(Kinematics, HalfATurnIsAboutItsAxis) {
  for (const Vec3 axis : {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2 / 3.0, -2 / 3.0, 1 / 3.0}}) {
    const Eigen::Vector3d along(axis.x, axis.y, axis.z);
    const Pose half(Eigen::AngleAxisd(2 * kQuarter, along));
    const Vec3 turn = turn_between(kNoRotation, from_eigen(half).rotation);
    EXPECT_NEAR(length(turn), 2 * kQuarter, 1e-12);
    EXPECT_NEAR(std::abs(dot(turn, axis)), 2 * kQuarter, 1e-12);
  }
}

TEST(Kinematics, RefusesValuesThatAreNotTheJoints) {
  const Robot robot = two_links();
  const SceneSensor sensor(robot, {});
  for (const JointVector& q :
       {joints({}), joints({0}), joints({0, 0, 0}), joints({0, std::nan("")}), joints({1e6 + 1, 0}),
        joints({0, -1e18}), joints({1e300, 0})}) {
    EXPECT_THROW(tip_position(robot, q), Error);
    EXPECT_THROW(place_links(robot, q), Error);
    EXPECT_THROW(sensor.contact(q), Error);
    EXPECT_THROW(sensor.motion_free(q, joints({0, 0})), Error);
    EXPECT_THROW(sensor.motion_free(joints({0, 0}), q), Error);
  }
  Robot centipede = robot;
  centipede.joints.resize(Robot::kMaxJoints + 1, robot.joints[1]);
  const JointVector zeros = JointVector::Zero(centipede.size());
  EXPECT_THROW(tip_position(centipede, zeros), Error);
  EXPECT_THROW(place_links(centipede, zeros), Error);
  EXPECT_THROW(tip_position(Robot(), joints({})), Error);
}

TEST(Kinematics, ReachesWhatIsInReachWithinItsLimits) {
  std::mt19937 engine(3);
  for (const char* name : {"planar3", "industrial6", "redundant7"}) {
    const Robot robot = shipped(name);
    const Kinematics arm(robot);
    int reached = 0;
    constexpr int kTries = 200;
    for (int i = 0; i < kTries; ++i) {
      std::vector<double> from, to;
      for (const Joint& joint : robot.joints) {
        std::uniform_real_distribution<double> value(0.6 * joint.low, 0.6 * joint.high);
        from.push_back(value(engine));
        to.push_back(from.back() + 0.1 * std::sin(10 * value(engine)));
      }
      const auto values = [](const std::vector<double>& v) {
        return Eigen::Map<const JointVector>(v.data(), static_cast<Eigen::Index>(v.size()));
      };
      const Vec3 target = tip_position(robot, values(to));
      std::vector<double> q = from;
      if (!arm.reach_for(target, from, q)) continue;
      ++reached;
      EXPECT_LE(distance(tip_position(robot, values(q)), target), Kinematics::kTolerance);
      for (int j = 0; j < robot.size(); ++j) {
        EXPECT_GE(q[j], robot.joints[j].low);
        EXPECT_LE(q[j], robot.joints[j].high);
        EXPECT_LT(std::abs(q[j] - from[j]), 1.5) << "far from where it began";
      }
    }
    EXPECT_GE(reached, kTries * 95 / 100) << name;
  }
}

TEST(Kinematics, AmongSolutionsTakesOneNearRest) {
  // Three links in a plane have a freedom to spare: no other solution nearby is nearer to rest.
  const Robot robot = shipped("planar3");
  const Kinematics arm(robot);
  const std::vector<double> rest{0.2, 0.6, 0.4};
  std::vector<double> q{0.1, 0.7, 0.5};
  ASSERT_TRUE(arm.reach_for({0.5, 0.5, 0}, rest, q));
  const auto apart = [&](const std::vector<double>& a) {
    double sum = 0;
    for (int j = 0; j < 3; ++j) sum += (a[j] - rest[j]) * (a[j] - rest[j]);
    return sum;
  };
  for (const double shift : {-0.02, 0.02}) {
    // Another solution: the first joint moved, the others solved for by the same solver, held to
    // the same target with rest at the shifted values.
    std::vector<double> other = q, near = q;
    near[0] += shift;
    other = near;
    ASSERT_TRUE(arm.reach_for({0.5, 0.5, 0}, near, other));
    EXPECT_GT(apart(other), apart(q));
  }
}

TEST(Kinematics, RefusesWhatIsOutOfReachOrBeyondALimit) {
  Robot robot = two_links();
  std::vector<double> q{0.3, 0.3};
  EXPECT_FALSE(Kinematics(robot).reach_for({0.91, 0, 0}, q, q));
  EXPECT_FALSE(Kinematics(robot).reach_for({0.5, 0, 0.1}, q, q));
  robot.joints[1].high = 0.5;  // the tip cannot come nearer to the base than this allows
  q = {0.3, 0.3};
  EXPECT_FALSE(Kinematics(robot).reach_for({0.4, 0, 0}, q, q));
}

TEST(Robot, WhatIsOutOfItsRangeIsRefusedByName) {
  const auto refused = [](const std::string& words, auto spoil) {
    Robot robot = two_links();
    spoil(robot, robot.joints[1], robot.links[1]);
    expect_says(error_of([&] { validate(robot); }, words), words);
  };
  refused("its axis", [](auto&, auto& j, auto&) { j.axis.z() = 2; });
  refused("its limits", [](auto&, auto& j, auto&) { j.low = 4; });
  refused("2: velocity", [](auto&, auto& j, auto&) { j.velocity = 0.9e-9; });
  refused("acceleration", [](auto&, auto& j, auto&) { j.acceleration = 1e-200; });
  refused("2: its jerk", [](auto&, auto& j, auto&) { j.jerk = -1; });
  refused("2: its jerk", [](auto&, auto& j, auto&) { j.jerk = NAN; });
  refused("state \"up\" has", [](auto& r, auto&, auto&) { r.states["up"] = joints({1}); });
  refused("state \"up\" has", [](auto& r, auto&, auto&) { r.states["up"] = joints({0, NAN}); });
  refused("2: its rotation", [](auto&, auto& j, auto&) { j.frame.linear().col(2) *= -1; });
  refused("2: its kind is 9", [](auto&, auto& j, auto&) { j.kind = Joint::Kind{9}; });
  refused("2: it is prismatic and", [](auto&, auto& j, auto&) {
    j.kind = Joint::Kind::prismatic;
    j.continuous = true;
  });
  refused("2: its shape is 9", [](auto&, auto&, auto& l) { l.solids[0].shape = Solid::Shape{9}; });
  refused("of a capsule 0", [](auto&, auto&, auto& l) { l.solids[0].radius = -1; });
  refused("links[1].body is 99", [](auto&, auto&, auto& l) { l.body = 99; });
  refused("links[1].parent is 2", [](auto&, auto&, auto& l) { l.parent = 2; });
  refused("links[1].parent is 1", [](auto&, auto&, auto& l) { l.parent = 1; });
  refused("links[0].parent is 1", [](auto& r, auto&, auto&) { r.links[0].parent = 1; });
}

TEST(Robot, HasAsManyJointsAsItMayHave) {
  Robot robot = two_links();
  robot.joints.resize(Robot::kMaxJoints, robot.joints[1]);
  EXPECT_NO_THROW(validate(robot));
  robot.joints.push_back(robot.joints[1]);
  expect_says(error_of([&] { validate(robot); }), "17 joints");
}

}  // namespace
}  // namespace lasius::arm
