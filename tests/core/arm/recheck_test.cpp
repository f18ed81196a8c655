#include <gtest/gtest.h>

#include "lasius/arm/sensor.h"
#include "lasius/arm/trajectory.h"
#include "lasius/base/error.h"
#include "tests/core/arm/robot/arms.h"
#include "tests/core/base/counting_time.h"
#include "tests/oracle/arm/fcl_judge.h"

namespace lasius::arm {
namespace {

TEST(Recheck, SeesContactsAndBrokenLimits) {
  const Robot robot = two_links();
  Obstacle box;
  box.pose.translation() = Eigen::Vector3d(0.9, 0, 0);
  box.size = {0.1, 0.1, 0.1};
  const Trajectory still({{0, joints({0, 0}), joints({0, 0})}});
  EXPECT_EQ(recheck(robot, {"", {box}}, still, 10).contacts, 10);
  EXPECT_EQ(recheck(robot, {}, still, 10).contacts, 0);
  const Trajectory hasty(
      {{0, joints({0, 0}), joints({0, 0})}, {0.01, joints({1, 0}), joints({0, 0})}});
  EXPECT_GT(recheck(robot, {}, hasty, 10).limits, 0);
}

TEST(Recheck, SeesJerkAboveItsLimit) {
  // From rest to an acceleration of 0.1 and back in two seconds each way: 0.05 a second.
  const JointVector none = joints({0, 0}), some = joints({0.1, 0});
  const Trajectory even({{0, none, none}, {2, none, some}, {4, none, none}});
  const Trajectory jump({{0, none, some}, {4, none, none}});
  Robot robot = two_links();
  EXPECT_EQ(recheck(robot, {}, even, 3).limits, 0);
  EXPECT_EQ(recheck(robot, {}, jump, 3).limits, 0);
  robot.joints[0].jerk = 0.0501;
  EXPECT_EQ(recheck(robot, {}, even, 3).limits, 0);
  EXPECT_EQ(recheck(robot, {}, jump, 3).limits, 1);  // at the start only
  robot.joints[0].jerk = 0.0499;
  EXPECT_EQ(recheck(robot, {}, even, 3).limits, 2);
}

TEST(Recheck, LooksBetweenItsSamples) {
  // Swings over a thin rod between two samples, or stops before it.
  const Robot robot = two_links();
  Obstacle rod;
  rod.pose.translation() = Eigen::Vector3d(0.3, 0.4, 0);
  rod.size = {0.002, 0.002, 0.002};
  const auto swing = [](double to) {
    return Trajectory({{0, joints({0, 0}), joints({0, 0})}, {1, joints({to, 0}), joints({0, 0})}});
  };
  const Recheck over = recheck(robot, {"", {rod}}, swing(2), 2);
  EXPECT_EQ(over.contacts, 0);
  EXPECT_EQ(over.unproven, 1);
  EXPECT_EQ(recheck(robot, {"", {rod}}, swing(0.85), 2).unproven, 0);
  const Trajectory to_and_fro({{0, joints({0.8, 0}), joints({0, 0})},
                               {1, joints({1, 0}), joints({0, 0})},
                               {2, joints({0.8, 0}), joints({0, 0})}});
  EXPECT_EQ(recheck(robot, {"", {rod}}, to_and_fro, 2).unproven, 1);
}

TEST(Recheck, MeasuresMeshesWithoutAreaOrTrianglesAsFclDoes) {
  const Eigen::Vector3d p(0.2, 0.03, -0.01), u(0.1, 0.02, 0.03), q = p + u, m = p + 0.3 * u;
  Obstacle box, null = mesh_of({});
  box.size = {0.1, 0.2, 0.3};
  null.triangles = nullptr;
  for (const Obstacle& flat : {null, mesh_of({}), mesh_of({{p, p, p}}), mesh_of({{p, m, q}}),
                               mesh_of({{p, p, q}}), mesh_of({{p, q, q}})}) {
    Robot robot = two_links();
    robot.links[1].solids = {flat};
    for (Obstacle other : {box, ball({0, 0, 0}, 0.1), mesh_of(cube(0.1)), mesh_of({{u, u, p}})}) {
      other.pose.translation() = Eigen::Vector3d(0.5, 0.6, 0.02);
      const Scene scene{"", {null, other, mesh_of({})}};
      for (const double turn : {0.0, 0.4, 0.9, 1.4}) {
        const JointVector at = joints({turn, 0.3});
        const Recheck check = recheck(robot, scene, Trajectory({{0, at, joints({0, 0})}}), 1);
        EXPECT_NEAR(check.nearest, oracle::FclJudge(robot, scene).distance(at), 1e-5) << turn;
        EXPECT_GT(check.nearest, 0.001);
      }
    }
  }
}

TEST(Recheck, EndsWhenToldTo) {
  const Trajectory still({{0, joints({0, 0}), joints({0, 0})}});
  EXPECT_LT(recheck(two_links(), {}, still, 100, fired()).samples, 100);
  EXPECT_EQ(recheck(two_links(), {}, still, 100).samples, 100);
}

TEST(Recheck, RefusesWhatDoesNotFit) {
  const Robot robot = two_links();
  const Trajectory still({{0, joints({0, 0}), joints({0, 0})}});
  EXPECT_THROW(recheck(robot, {}, Trajectory(), 10), Error);
  EXPECT_THROW(recheck(robot, {}, Trajectory({{0, joints({0}), joints({0})}}), 10), Error);
  EXPECT_THROW(recheck(robot, {}, Trajectory({{0, joints({0, 0}), joints({0})}}), 10), Error);
  EXPECT_THROW(recheck(robot, {}, still, 0), Error);
  EXPECT_THROW(recheck(Robot(), {}, still, 10), Error);
  EXPECT_THROW(recheck(robot, {"", {Obstacle()}}, still, 10), Error) << "a box without a size";
}

}  // namespace
}  // namespace lasius::arm
