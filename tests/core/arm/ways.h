// Ways and limits drawn for tests of motions, and what all motions keep.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "core/arm/blends.h"
#include "core/arm/spline.h"
#include "lasius/arm/trajectory.h"
#include "tests/core/arm/questions.h"

namespace lasius::arm {

/// Joints with limits drawn at random, no bodies.
inline Robot any_limits(std::mt19937& engine, int size) {
  std::uniform_real_distribution<double> share(0, 1);
  Robot robot = two_links();
  robot.links.clear();
  robot.joints.resize(static_cast<std::size_t>(size), robot.joints[0]);
  for (Joint& joint : robot.joints) {
    joint.velocity = 0.5 + 2 * share(engine);
    joint.acceleration = 1 + 6 * share(engine);
  }
  return robot;
}

inline std::vector<JointVector> any_way(std::mt19937& engine, int size, int count) {
  std::uniform_real_distribution<double> value(-1.5, 1.5);
  std::vector<JointVector> way(static_cast<std::size_t>(count), JointVector(size));
  for (JointVector& q : way)
    for (double& v : q) v = value(engine);
  return way;
}

inline std::vector<double> blend_sizes(const std::vector<JointVector>& way, double share = 1) {
  std::vector<double> sizes(way.size(), 0);
  for (std::size_t i = 1; i + 1 < way.size(); ++i) sizes[i] = share * largest_blend(way, i);
  return sizes;
}

/// How far joint values are from the straight lines of a way.
inline double off(const std::vector<JointVector>& way, const JointRef& q) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const JointVector edge = way[i + 1] - way[i];
    const double share = std::clamp((q - way[i]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (way[i] + share * edge - q).norm());
  }
  return least;
}

/// Free are postures no further than `width` from the way; curves are not known to it.
class Corridor : public Nothing {
 public:
  Corridor(std::vector<JointVector> way, double width) : way_(std::move(way)), width_(width) {}
  bool position_free(const JointRef& q) const override { return off(way_, q) <= width_; }
  bool motion_free(const JointRef& a, const JointRef& b) const override {
    for (int k = 0; k <= 20; ++k)
      if (!position_free(a + k / 20.0 * (b - a))) return false;
    return true;
  }

 private:
  std::vector<JointVector> way_;
  double width_;
};

/// Velocity goes on at all knots, limits hold all along, and jerk where it has any.
inline void expect_sound(const Robot& robot, const Trajectory& t) {
  EXPECT_LE(needed_stretch(robot, t), 1 + 1e-9);
  const double step = 1e-7 * t.duration();
  for (const auto& knot : t.knots()) {
    const auto before = t.at(knot.time - step), after = t.at(knot.time + step);
    for (int j = 0; j < robot.size(); ++j) {
      const Joint& joint = robot.joints[j];
      ASSERT_NEAR(before.q[j], after.q[j], 3 * joint.velocity * step + 1e-9);
      ASSERT_NEAR(before.dq[j], after.dq[j], 3 * joint.acceleration * step + 1e-8);
      if (joint.jerk > 0) {
        ASSERT_NEAR(before.ddq[j], after.ddq[j], 3 * joint.jerk * step + 1e-8) << knot.time;
      }
    }
  }
}

}  // namespace lasius::arm
