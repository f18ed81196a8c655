// Postures and things around an arm, drawn.
#pragma once

#include <algorithm>
#include <memory>
#include <random>
#include <utility>

#include "core/arm/robot/vec3.h"
#include "kernels/base/sine.h"

namespace lasius::arm {

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  bool one_in(int n) { return between(0, n) < 1; }
  Vec3 point(double half) {
    return {between(-half, half), between(-half, half), between(-half, half)};
  }
  Placement pose(double half) {
    const Vec3 at = point(half);
    return {roll_pitch_yaw(point(3)), at};
  }
  JointVector values(const Robot& robot) {
    JointVector q(robot.size());
    for (int j = 0; j < robot.size(); ++j) {
      q[j] = between(std::max(-3.0, robot.joints[j].low), std::min(3.0, robot.joints[j].high));
    }
    return q;
  }

 private:
  std::mt19937 engine_;
};

/// A closed surface like a ball of unit radius, in so many rings.
inline Triangles globe(int rings) {
  const auto at = [&](int ring, int side) {
    const double pi = 3.14159265358979323846;
    const auto polar = kernels::sine_cosine(pi * ring / rings);
    const auto around = kernels::sine_cosine(pi * side / rings);
    return Eigen::Vector3d(polar.sine * around.cosine, polar.sine * around.sine, polar.cosine);
  };
  Triangles triangles;
  for (int r = 0; r < rings; ++r) {
    for (int s = 0; s < 2 * rings; ++s) {
      triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
      triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
    }
  }
  return triangles;
}

/// Things of all shapes in reach.
inline Scene any_scene(Draw& draw, int count) {
  Scene scene;
  for (int i = 0; i < count; ++i) {
    Obstacle o;
    o.shape = static_cast<Solid::Shape>(i % 5);
    o.pose = to_eigen(draw.pose(0.9));
    o.radius = draw.between(0.02, 0.12);
    o.length = draw.between(0.05, 0.4);
    o.size = {draw.between(0.02, 0.3), draw.between(0.02, 0.3), draw.between(0.02, 0.3)};
    if (o.shape == Solid::Shape::mesh) {
      Triangles triangles = globe(6);
      for (auto& triangle : triangles) {
        for (Eigen::Vector3d& corner : triangle) corner = corner.cwiseProduct(o.size);
      }
      o.triangles = std::make_shared<const Triangles>(std::move(triangles));
    }
    scene.obstacles.push_back(o);
  }
  return scene;
}

}  // namespace lasius::arm
