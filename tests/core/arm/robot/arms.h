// Arms and obstacles for tests.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "core/arm/robot/vec3.h"
#include "lasius/arm/robot.h"

namespace lasius::arm {

inline Robot shipped(const std::string& name) {
  return read_robot(LASIUS_MAPS_DIR "/arms/" + name + ".json");
}

/// A value for each joint.
inline JointVector joints(std::initializer_list<double> values) {
  JointVector q(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), q.begin());
  return q;
}

inline std::vector<JointVector> positions(
    std::initializer_list<std::initializer_list<double>> points) {
  std::vector<JointVector> way;
  for (const auto& point : points) way.push_back(joints(point));
  return way;
}

/// A column for each waypoint.
inline Eigen::MatrixXd columns(const std::vector<JointVector>& waypoints) {
  Eigen::MatrixXd way(waypoints.empty() ? 0 : waypoints[0].size(),
                      static_cast<Eigen::Index>(waypoints.size()));
  for (std::size_t i = 0; i < waypoints.size(); ++i)
    way.col(static_cast<Eigen::Index>(i)) = waypoints[i];
  return way;
}

/// Two links of 0.5 and 0.4 in the plane z = 0, wide limits, thin.
inline Robot two_links() {
  Robot robot;
  for (const double length : {0.5, 0.4}) {
    Joint joint;
    if (!robot.joints.empty()) joint.frame.translation().x() = 0.5;
    joint.low = -3;
    joint.high = 3;
    joint.velocity = 2;
    joint.acceleration = 5;
    const int number = robot.size();
    robot.joints.push_back(joint);
    Solid capsule;
    capsule.shape = Solid::Shape::capsule;
    capsule.size = {length, 0, 0};
    capsule.radius = 0.01;
    robot.links.push_back(
        {.name = {}, .body = number + 1, .parent = number - 1, .solids = {capsule}});
  }
  robot.tip.translation().x() = 0.4;
  return robot;
}

inline Obstacle ball(const Eigen::Vector3d& at, double radius) {
  Obstacle ball;
  ball.shape = Solid::Shape::sphere;
  ball.pose.translation() = at;
  ball.radius = radius;
  return ball;
}

/// The surface of a cube.
inline Triangles cube(double half) {
  Triangles triangles;
  for (int axis = 0; axis < 6; ++axis) {
    const Eigen::Matrix3d sides = (axis < 3 ? half : -half) * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d u = sides.col((axis + 1) % 3), v = sides.col((axis + 2) % 3);
    const Eigen::Vector3d middle = sides.col(axis % 3);
    triangles.push_back({middle - u - v, middle + u - v, middle + u + v});
    triangles.push_back({middle - u - v, middle + u + v, middle - u + v});
  }
  return triangles;
}

inline Obstacle mesh_of(const Triangles& triangles) {
  Obstacle mesh;
  mesh.shape = Solid::Shape::mesh;
  mesh.triangles = std::make_shared<const Triangles>(triangles);
  return mesh;
}

}  // namespace lasius::arm
