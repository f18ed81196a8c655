// Outlines of solids, as pictures show them from any side.
#pragma once

#include <vector>

#include "lasius/arm/robot.h"
#include "lasius/grid/geometry.h"

namespace lasius::tool {

/// Points of a solid's surface whose convex hull is its outline in every view along an axis.
std::vector<Eigen::Vector3d> outline(const arm::Solid& solid);

/// The convex hull (Andrew's monotone chain), its corners in order.
std::vector<Point> hull(std::vector<Point> points);

/// Where the frames of the base and of each joint, moved, are at joint values `q`.
std::vector<arm::Pose> body_poses(const arm::Robot& robot, const arm::JointVector& q);

}  // namespace lasius::tool
