// Requests for arms from a seed.
#pragma once

#include <cstdint>

#include "lasius/arm/robot.h"

namespace lasius::arm {

/// What kind of request is wanted.
struct GenerateOptions {
  std::uint64_t seed = 1;  ///< of all that is drawn
  int obstacles = 20;      ///< besides the wall; 0 .. 1000
  /// A plate between start and goal, this many times as wide and high as they are apart; 0: none.
  double wall = 0;
  double least_distance = 0.3;  ///< of start and goal, as a share of the arm's reach; up to 1
};

/// A request to the planner, with its world.
struct Query {
  Scene scene;                                     ///< what stands around the arm
  JointVector start;                               ///< a value for each joint, free
  Eigen::Vector3d goal = Eigen::Vector3d::Zero();  ///< of the tip, at a free position of the arm
  JointVector goal_joints;                         ///< that position
};

/// Boxes, spheres and cylinders within the arm's reach, a start and a goal: both are positions of
/// the arm that touch nothing. The same on every machine.
/// @throws Error(invalid_parameter) for a robot that `validate` refuses, for options out of range,
///         and where no such request is found: too many obstacles for this arm.
LASIUS_ARM_EXPORT Query generate_query(const Robot& robot, const GenerateOptions& options);

}  // namespace lasius::arm
