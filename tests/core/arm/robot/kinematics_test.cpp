#include "core/arm/robot/kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/arm/robot/vec3.h"
#include "lasius/error.h"
#include "tests/core/arm/robot/arms.h"

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

TEST(Kinematics, RefusesValuesThatAreNotTheJoints) {
  const Robot robot = two_links();
  for (const JointVector& q :
       {joints({}), joints({0}), joints({0, 0, 0}), joints({0, std::nan("")})}) {
    EXPECT_THROW(tip_position(robot, q), Error);
    EXPECT_THROW(place_links(robot, q), Error);
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

TEST(Robot, ShippedOnesAreValidAndAgreeWithKdl) {
  for (const char* name : {"planar3", "industrial6", "redundant7"}) {
    const Robot robot = shipped(name);
    EXPECT_NO_THROW(validate(robot)) << name;
    EXPECT_FALSE(robot.name.empty());
  }
  EXPECT_EQ(shipped("planar3").size(), 3);
  EXPECT_EQ(shipped("industrial6").size(), 6);
  EXPECT_EQ(shipped("redundant7").size(), 7);
}

}  // namespace
}  // namespace lasius::arm
