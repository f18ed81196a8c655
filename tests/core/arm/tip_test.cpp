// Inverse kinematics, straight motions of the tip, and what an arm holds.
#include <gtest/gtest.h>

#include <cmath>

#include "lasius/arm/plan.h"
#include "lasius/arm/sensor.h"
#include "lasius/base/error.h"
#include "tests/core/arm/robot/arms.h"
#include "tests/core/base/counting_time.h"

namespace lasius::arm {
namespace {

const JointVector& bent() {
  static const JointVector q = joints({0.3, 0.4, 0.7, 0.2, 0.6, 0.1});
  return q;
}

TEST(InverseKinematics, AllReachThePoseTheNearestFirst) {
  const Robot robot = shipped("industrial6");
  const Pose pose = tip_pose(robot, bent());
  const auto found = inverse_kinematics(robot, Goal::pose(pose), bent());
  ASSERT_GE(found.size(), 3U);
  EXPECT_LT((found[0] - bent()).norm(), 1e-5);
  double before = 0;
  for (const JointVector& q : found) {
    EXPECT_LT((tip_pose(robot, q).matrix() - pose.matrix()).norm(), 1e-6);
    EXPECT_GE((q - bent()).norm(), before);
    before = (q - bent()).norm();
    for (int j = 0; j < robot.size(); ++j) {
      EXPECT_GE(q[j], robot.joints[j].low);
      EXPECT_LE(q[j], robot.joints[j].high);
    }
  }
  EXPECT_EQ(inverse_kinematics(robot, Goal::pose(pose), bent(), 1).size(), 1U);
  const Goal far(Eigen::Vector3d(100, 0, 0));
  EXPECT_THROW(inverse_kinematics(robot, far, bent()), Error);
}

/// Off the straight line, and off the even turn, at a hundred instants of each motion.
std::pair<double, double> worst_of(const Robot& robot, const TipLine& line, const Pose& goal) {
  const Pose begin = tip_pose(robot, line.joints.col(0));
  const Eigen::Vector3d way = goal.translation() - begin.translation();
  const Eigen::AngleAxisd turn((goal.linear() * begin.linear().transpose()).eval());
  double off = 0, turned = 0;
  for (Eigen::Index i = 1; i < line.joints.cols(); ++i) {
    for (int s = 0; s <= 100; ++s) {
      const JointVector q =
          line.joints.col(i - 1) + s / 100.0 * (line.joints.col(i) - line.joints.col(i - 1));
      const Pose at = tip_pose(robot, q);
      const double share = (at.translation() - begin.translation()).dot(way) / way.squaredNorm();
      off = std::max(off, (at.translation() - begin.translation() - share * way).norm());
      const Eigen::Matrix3d even =
          Eigen::AngleAxisd(share * turn.angle(), turn.axis()).toRotationMatrix() * begin.linear();
      const Eigen::AngleAxisd wrong((at.linear() * even.transpose()).eval());
      turned = std::max(turned, std::abs(wrong.angle()));
    }
  }
  return {off, turned};
}

TEST(TipLine, KeepsToTheLineAllAlong) {
  const Robot robot = shipped("industrial6");
  const SceneSensor sensor(robot, {});
  Pose goal = tip_pose(robot, bent());
  goal.translation() += Eigen::Vector3d(0.05, -0.2, -0.1);
  goal.linear() = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix() *
                  goal.linear();
  std::size_t before = 0;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const TipLine line =
        tip_line(robot, sensor, bent(), goal, {.tolerance = tolerance, .angle_tolerance = 0.01});
    ASSERT_EQ(line.status, Status::solved) << line.error;
    EXPECT_EQ(line.reached, 1);
    EXPECT_EQ(line.joints.col(0), bent());
    const auto [off, turned] = worst_of(robot, line, goal);
    EXPECT_LE(off, tolerance);
    EXPECT_LE(turned, 0.02);  // the place along the line is not that of the time
    EXPECT_LT((tip_pose(robot, line.joints.rightCols<1>()).matrix() - goal.matrix()).norm(), 1e-7);
    EXPECT_GE(static_cast<std::size_t>(line.joints.cols()), before);
    before = static_cast<std::size_t>(line.joints.cols());
  }
  EXPECT_GT(before, 4U);
}

TEST(TipLine, ItsMotionKeepsToTheLineAllAlong) {
  const Robot robot = shipped("industrial6");
  const SceneSensor sensor(robot, {});
  Pose goal = tip_pose(robot, bent());
  goal.translation() += Eigen::Vector3d(0.05, -0.2, -0.1);
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const TipLine line =
        tip_line(robot, sensor, bent(), goal, {.tolerance = tolerance, .motion = true});
    ASSERT_EQ(line.status, Status::solved) << line.error;
    EXPECT_FALSE(line.stops);
    TipLine samples = line;
    constexpr int kCount = 300;
    samples.joints.resize(robot.size(), kCount + 1);
    for (int i = 0; i <= kCount; ++i)
      samples.joints.col(i) = line.trajectory.at(i * line.trajectory.duration() / kCount).q;
    const auto [off, turned] = worst_of(robot, samples, goal);
    EXPECT_LE(off, tolerance);
    EXPECT_LE(turned, 0.01);
    EXPECT_EQ(recheck(robot, {}, line.trajectory, 50).limits, 0);
  }
}

/// Tells to stop in its so-manieth question about a curve, and leaves that one open.
class StopsInACurve final : public Sensor {
 public:
  StopsInACurve(const Sensor& sensor, int at) : sensor_(sensor), left_(at) {}
  bool position_free(const JointRef& q) const override { return sensor_.position_free(q); }
  bool motion_free(const JointRef& from, const JointRef& to) const override {
    return sensor_.motion_free(from, to);
  }
  std::optional<bool> try_curve(const Trajectory& curve, double from, double to,
                                const StopCondition& stop) const override {
    if (--left_ == 0) source.request_stop();
    if (stop.poll() != StopCondition::Cause::none) return std::nullopt;
    return sensor_.try_curve(curve, from, to, stop);
  }
  double clearance() const override { return sensor_.clearance(); }
  int left() const { return left_; }

  mutable std::stop_source source;

 private:
  const Sensor& sensor_;
  mutable int left_;
};

TEST(TipLine, AStopIsNothingInTheWay) {
  const Robot robot = shipped("industrial6");
  const SceneSensor scene(robot, {});
  Pose goal = tip_pose(robot, bent());
  goal.translation() += Eigen::Vector3d(0.05, -0.2, -0.1);
  for (int at = 1;; at = 2 * at) {
    const StopsInACurve sensor(scene, at);
    const TipLine line = tip_line(robot, sensor, bent(), goal,
                                  {.stop = {.token = sensor.source.get_token()}, .motion = true});
    if (sensor.left() > 0) {
      EXPECT_GT(at, 4);
      EXPECT_EQ(line.status, Status::solved);
      break;
    }
    EXPECT_EQ(line.status, Status::interrupted) << at;
  }
}

TEST(TipLine, EndsWhereSomethingIsInTheWayAndSaysWhat) {
  const Robot robot = shipped("industrial6");
  Pose goal = tip_pose(robot, bent());
  const Eigen::Vector3d begin = goal.translation();
  goal.translation() += Eigen::Vector3d(0.05, -0.3, -0.1);
  Scene scene;
  Obstacle ball;
  ball.shape = Solid::Shape::sphere;
  ball.radius = 0.02;
  ball.name = "ball";
  ball.pose.translation() = 0.3 * begin + 0.7 * goal.translation();
  scene.obstacles.push_back(ball);
  const TipLine line = tip_line(robot, SceneSensor(robot, scene), bent(), goal);
  EXPECT_EQ(line.status, Status::no_path);
  EXPECT_GT(line.reached, 0.1);
  EXPECT_LT(line.reached, 0.7);
  EXPECT_NE(line.error.find("ball"), std::string::npos) << line.error;
  Pose far = goal;
  far.translation().x() += 100;
  EXPECT_NE(tip_line(robot, SceneSensor(robot, {}), bent(), far).error, "");
  EXPECT_THROW(tip_line(robot, SceneSensor(robot, {}), bent(), goal, {.tolerance = 0}), Error);
  const StopCondition told = fired();
  EXPECT_EQ(tip_line(robot, SceneSensor(robot, {}), bent(), goal, {.stop = told}).status,
            Status::interrupted);
}

TEST(Holding, WhatIsHeldIsPartOfTheArm) {
  const Robot robot = shipped("industrial6");
  const Pose tip = tip_pose(robot, bent());
  Solid stick;
  stick.shape = Solid::Shape::capsule;
  stick.radius = 0.01;
  stick.size = {0, 0, 0.3};
  stick.pose.translation() = Eigen::Vector3d(0, 0, 0.02);
  const Robot with = holding(robot, "stick", {stick});
  Scene scene;
  Obstacle ball;
  ball.shape = Solid::Shape::sphere;
  ball.radius = 0.02;
  ball.pose.translation() = tip * Eigen::Vector3d(0, 0, 0.4);
  scene.obstacles.push_back(ball);
  // From the stick's end to the ball: 0.4 - 0.32 - 0.01 - 0.02.
  const SceneSensor::Nearest near = SceneSensor(with, scene).nearest(bent());
  EXPECT_NEAR(near.distance, 0.05, 1e-9);
  EXPECT_NE(near.link.find("stick"), std::string::npos);
  EXPECT_GT(SceneSensor(robot, scene).distance(bent()), near.distance + 1e-3);
  EXPECT_EQ(tip_pose(with, bent()).matrix(), tip.matrix());
  EXPECT_THROW(holding(robot, "stick", {stick}, {"nothing of this name"}), Error);
  EXPECT_EQ(holding(robot, "stick", {stick}, {"link 5 (after pitch)"}).may_touch.size(),
            robot.may_touch.size() + 1);
  EXPECT_THROW(holding(robot, "stick", {stick}, {""}), Error);
}

}  // namespace
}  // namespace lasius::arm
