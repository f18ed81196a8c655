// Motions that the library calls free, judged by FCL on the whole URDF, read by other code.
// LASIUS_ORACLE_SCENES sets how many scenes there are in all (default 40).
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "lasius/arm/generate.h"
#include "lasius/arm/trajectory.h"
#include "tests/core/arm/robot/arms.h"
#include "tests/oracle/arm/urdf_oracle.h"

namespace lasius::arm {
namespace {

const std::string kRobots = LASIUS_MAPS_DIR "/../tests/core/arm/robots";

struct Case {
  const char* name;
  const char* tip;
  std::map<std::string, double> set;
};

const Case kCases[] = {
    {"ur5", "tool0", {}},
    {"puma560", "tool", {}},
    {"scara", "tool", {}},
    {"planar2", "tool", {}},
    {"planar3", "tool", {}},
    {"seven", "tool", {}},
    {"ur5_gripper", "tool0", {{"left_finger_joint", 0.02}}},
    {"branch", "tool", {{"flag_turn", 1.2}}},
};

/// A mesh in reach of most arms.
Obstacle wedge(double height) {
  Triangles triangles = read_mesh(kRobots + "/wedge.stl");
  for (auto& triangle : triangles) {
    for (Eigen::Vector3d& corner : triangle) corner *= 0.3;
  }
  Obstacle mesh = mesh_of(triangles);
  mesh.pose.translation() = Eigen::Vector3d(0.35, -0.2, height);
  return mesh;
}

int scenes_of_each() {
  const char* const all = std::getenv("LASIUS_ORACLE_SCENES");
  return ((all != nullptr ? std::atoi(all) : 40) + 7) / 8;
}

class MotionOracle : public testing::TestWithParam<Case> {
 protected:
  MotionOracle()
      : robot_(read_robot(file(), {.tip = GetParam().tip,
                                   .set_joints = GetParam().set,
                                   .packages = {{"parts", kRobots}}})),
        oracle_(file(), names(), GetParam().set, kRobots) {}

  static std::string file() { return kRobots + "/" + GetParam().name + ".urdf"; }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const Joint& joint : robot_.joints) names.push_back(joint.name);
    return names;
  }
  JointVector draw(std::mt19937& engine) const {
    JointVector q(robot_.size());
    for (int j = 0; j < robot_.size(); ++j) {
      const Joint& joint = robot_.joints[j];
      const double low = joint.continuous ? -3 : joint.low,
                   high = joint.continuous ? 3 : joint.high;
      q[j] = std::uniform_real_distribution<double>(low, high)(engine);
    }
    return q;
  }

  Robot robot_;
  oracle::UrdfOracle oracle_;
};

// Also that little is called blocked that is not: solids are taken as they are.
TEST_P(MotionOracle, PositionsAreFreeWhereFclSaysSo) {
  std::mt19937 engine(5);
  int free = 0, wrong = 0;
  for (int scene = 0; scene < 5; ++scene) {
    Query query = generate_query(
        robot_, {.seed = static_cast<std::uint64_t>(scene) + 1, .obstacles = 3 * scene});
    if (scene > 2) query.scene.obstacles.push_back(wedge(0.2 * scene));
    oracle_.set_obstacles(query.scene.obstacles);
    const SceneSensor sensor(robot_, query.scene, 1e-6);
    for (int i = 0; i < 100; ++i) {
      const JointVector q = draw(engine);
      const std::string contact = oracle_.contact(q);
      const bool is_free = sensor.position_free(q);
      free += is_free;
      wrong += is_free != contact.empty();
      if (is_free) {
        EXPECT_EQ(contact, "") << q.transpose();
      }
    }
  }
  EXPECT_GT(free, 50);
  EXPECT_LE(wrong, 1) << "called blocked, and are not";
}

TEST_P(MotionOracle, NothingTouchesInAFreeMotion) {
  std::mt19937 engine(17);
  int motions = 0;
  for (int scene = 0; scene < scenes_of_each(); ++scene) {
    const Query query = generate_query(
        robot_, {.seed = static_cast<std::uint64_t>(scene) + 100, .obstacles = scene % 13});
    const SceneSensor sensor(robot_, query.scene);
    std::vector<JointVector> way{query.start};
    for (int i = 0; i < 60 && way.size() < 5; ++i) {
      const JointVector to = draw(engine);
      if (sensor.motion_free(way.back(), to)) way.push_back(to);
    }
    if (way.size() < 2) continue;
    const TrajectoryResult made = make_trajectory(robot_, sensor, columns(way));
    ++motions;
    oracle_.set_obstacles(query.scene.obstacles);
    constexpr int kSamples = 1000;
    for (int i = 0; i <= kSamples; ++i) {
      const JointVector q = made.trajectory.at(made.trajectory.duration() * i / kSamples).q;
      const std::string contact = oracle_.contact(q);
      ASSERT_EQ(contact, "") << "scene " << scene << ", at " << q.transpose();
    }
    const Recheck check = recheck(robot_, query.scene, made.trajectory, 200);
    EXPECT_EQ(check.contacts, 0) << scene;
    EXPECT_EQ(check.unproven, 0) << scene;
    EXPECT_EQ(check.limits, 0) << scene;
    EXPECT_LT(check.tip_error, 1e-12) << scene;
  }
  EXPECT_GE(3 * motions, scenes_of_each()) << "too few motions to say anything";
  std::printf("%d motions in %d scenes\n", motions, scenes_of_each());
}

INSTANTIATE_TEST_SUITE_P(Robots, MotionOracle, testing::ValuesIn(kCases),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace lasius::arm
