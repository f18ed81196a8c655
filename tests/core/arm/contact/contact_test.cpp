#include "core/arm/contact/contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/arm/contact/gjk.h"
#include "core/arm/contact/motion_bound.h"
#include "kernels/base/sine.h"
#include "lasius/arm/generate.h"
#include "lasius/arm/sensor.h"
#include "lasius/arm/trajectory.h"
#include "tests/core/arm/contact/draw.h"
#include "tests/core/arm/robot/arms.h"
#include "tests/core/base/counting_time.h"
#include "tests/oracle/arm/fcl_judge.h"

namespace lasius::arm {
namespace {

/// Joints that turn and joints that slide, in any order.
Robot any_robot(Draw& draw) {
  Robot robot;
  const int joints = 2 + static_cast<int>(draw.between(0, 5));
  for (int j = 0; j < joints; ++j) {
    Joint joint;
    joint.kind = draw.one_in(3) ? Joint::Kind::prismatic : Joint::Kind::revolute;
    joint.frame = to_eigen(draw.pose(0.5));
    joint.axis = Eigen::Vector3d(draw.point(1)).normalized();
    joint.low = -2;
    joint.high = 2;
    robot.joints.push_back(joint);
  }
  return robot;
}

TEST(Sine, AgreesWithTheLibraryWithinItsPromise) {
  for (double x = -70; x < 70; x += 0.0137) {
    const auto [s, c] = kernels::sine_cosine(x);
    ASSERT_NEAR(s, std::sin(x), 1e-15) << x;
    ASSERT_NEAR(c, std::cos(x), 1e-15) << x;
  }
}

TEST(MotionBound, HoldsForAllJointsAndPoints) {
  Draw draw(3);
  double largest = 0, sum = 0;
  int count = 0;
  for (int r = 0; r < 300; ++r) {
    const Robot robot = any_robot(draw);
    const Kinematics arm(robot);
    MotionBound bound(arm);
    const JointVector q = draw.values(robot);
    JointVector change = draw.values(robot);
    const double half = draw.between(0.01, 0.6);
    Kinematics::Poses poses, moved;
    arm.place(as_span(q), poses);
    JointVector bend = draw.values(robot).cwiseAbs() * draw.between(0, 1);
    if (r % 2 == 0) bend.setZero();
    bound.set(as_span(change), as_span(bend), half, poses);
    const auto seen = [&](const Kinematics::Poses& of, int body, int from, Vec3 p) {
      const Vec3 world = of[body - 1] * p;
      return from == 0 ? world : inverse(of[from - 1]) * world;
    };
    for (int i = 0; i < 40; ++i) {
      const double s = draw.between(-half, half);
      // At the largest bend to either side, the velocity in the middle as told.
      JointVector there = q + s * change;
      for (int j = 0; j < robot.size(); ++j)
        there[j] += (draw.between(-1, 1) < 0 ? -0.5 : 0.5) * s * s * bend[j];
      arm.place(as_span(there), moved);
      const int from = static_cast<int>(draw.between(0, robot.size()));
      const int body = from + 1 + static_cast<int>(draw.between(0, robot.size() - from));
      const RelativeMotion motion = bound.of(body, from);
      const Vec3 p = draw.point(0.4), world = poses[body - 1] * p;
      Vec3 expected = world + s * (cross(motion.turn, world) + motion.shift);
      if (from > 0) expected = inverse(poses[from - 1]) * expected;
      const double off = distance(seen(moved, body, from, p), expected);
      const double most = 0.5 * s * s * (motion.far + motion.spread * length(p));
      EXPECT_LE(off, most * (1 + 1e-9) + 1e-12) << r;
      if (most < 1e-9) continue;
      largest = std::max(largest, off / most);
      sum += off / most;
      ++count;
    }
  }
  // Bounds that say something: some are met, and half of them is used.
  EXPECT_GT(largest, 0.95);
  EXPECT_GT(sum / count, 0.3);
}

TEST(Hull, HoldsAllThatItCoversWithinItsMargin) {
  Draw draw(5);
  for (int round = 0; round < 60; ++round) {
    std::vector<Vec3> points;
    const int count = 1 + static_cast<int>(draw.between(0, 400));
    const bool flat = round % 3 == 0;
    for (int i = 0; i < count; ++i) {
      Vec3 p = draw.point(0.3);
      if (flat) p.z = 0.1;
      points.push_back(p);
    }
    const double wanted = draw.between(0, 0.02);
    const Hull hull(points, wanted);
    EXPECT_LE(hull.count(), 128);
    for (int i = 0; i < 200; ++i) {
      const Vec3 d = draw.point(1);
      double most = -1e9;
      for (const Vec3 p : points) most = std::max(most, dot(p, d));
      const double found = dot(hull.at(hull.furthest(d)), d);
      EXPECT_LE(most, found + hull.margin() * length(d));
      EXPECT_GE(most, found - 1e-7);
      const auto [index, second] = hull.furthest(d, 0.1, -1.0 * d, 0.1);
      EXPECT_LE(most, dot(hull.at(index), second ? -1.0 * d : d) + hull.margin() * length(d));
    }
  }
}

TEST(Gjk, NeverSaysMoreThanTheDistance) {
  // Balls of points: the distance is known.
  Draw draw(7);
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = draw.point(1), b = draw.point(1), half{0.2, 0.1, 0.3};
    const auto box = [&](Vec3 d) {
      return b + Vec3{d.x < 0 ? -half.x : half.x, d.y < 0 ? -half.y : half.y,
                      d.z < 0 ? -half.z : half.z};
    };
    const auto outside = [](double x, double most) { return std::max(0.0, std::abs(x) - most); };
    const double expected = length(
        {outside(a.x - b.x, half.x), outside(a.y - b.y, half.y), outside(a.z - b.z, half.z)});
    const double found = gjk_apart<GjkAsked::distance>([&](Vec3) { return a; }, box, a - b, 1e9);
    EXPECT_LE(found, expected + 1e-12);
    EXPECT_GE(found, expected - 1e-6 * expected - 2e-9);
    const double enough = draw.between(0.01, 1), capped = gjk_apart<GjkAsked::decision>(
                                                     [&](Vec3) { return a; }, box, a - b, enough);
    EXPECT_EQ(capped >= enough, expected >= enough) << expected - enough;
  }
}

TEST(Contact, DistancesAreFcls) {
  Draw draw(11);
  int apart = 0;
  for (const char* const name : {"industrial6", "planar3", "redundant7"}) {
    const Robot robot = shipped(name);
    for (int i = 0; i < 40; ++i) {
      const Scene scene = any_scene(draw, 5);
      const SceneSensor sensor(robot, scene);
      const JointVector q = draw.values(robot);
      const double expected = oracle::FclJudge(robot, scene).distance(q);
      const SceneSensor::Nearest nearest = sensor.nearest(q);
      EXPECT_NEAR(nearest.distance, expected, 2e-5) << name << " " << i;
      EXPECT_FALSE(nearest.link.empty() || nearest.other.empty());
      EXPECT_EQ(sensor.position_free(q), nearest.distance >= 2 * sensor.clearance());
      apart += nearest.distance > 0;
    }
  }
  EXPECT_GT(apart, 40);
}

TEST(Contact, MotionsAreFreeExactlyWhereNoPostureOfThemTouches) {
  // Postures every two thousandth of the way, by the same distances, which FCL holds.
  Draw draw(13);
  constexpr double kClearance = 1e-5;
  int free = 0, blocked = 0, doubtful = 0;
  for (const char* const name : {"industrial6", "planar3", "redundant7", "scara"}) {
    const Robot robot =
        std::string(name) == "scara"
            ? read_robot(LASIUS_MAPS_DIR "/../tests/core/arm/robots/scara.urdf", {.tip = "tool"})
            : shipped(name);
    const SceneSensor empty(robot, {}, kClearance);
    for (int i = 0; i < 60; ++i) {
      const SceneSensor sensor(empty, any_scene(draw, 5));
      const JointVector a = draw.values(robot);
      const JointVector b = a + draw.between(0.05, 1) * (draw.values(robot) - a);
      if (!sensor.position_free(a)) continue;
      double nearest = 1;
      for (int s = 0; s <= 2000 && nearest > 0; ++s)
        nearest = std::min(nearest, sensor.distance(a + s / 2000.0 * (b - a)));
      const bool is_free = sensor.motion_free(a, b);
      EXPECT_EQ(is_free, sensor.motion_free(b, a) && is_free);
      if (is_free) {
        EXPECT_GE(nearest, kClearance) << name << " " << i;
      }
      (is_free ? free : blocked)++;
      doubtful += !is_free && nearest > 1e-3;  // between two samples it is no nearer than this
    }
  }
  EXPECT_GT(free, 40);
  EXPECT_GT(blocked, 20);
  EXPECT_EQ(doubtful, 0);
}

TEST(Contact, AMotionIsCutWhereItIsToldToStop) {
  const Robot robot = shipped("industrial6");
  Draw draw(17);
  const SceneSensor sensor(robot, any_scene(draw, 200));
  const StopCondition stop = fired();
  const JointVector from = draw.values(robot), to = draw.values(robot);
  EXPECT_FALSE(sensor.try_motion(from, to, stop).has_value());
  EXPECT_EQ(sensor.try_motion(from, to, {}), sensor.motion_free(from, to));
}

}  // namespace
}  // namespace lasius::arm
