// The tip of an arm: joint values that reach a pose, straight motions of it, and what it holds.
#pragma once

#include <string>
#include <vector>

#include "lasius/arm_plan.h"

namespace lasius::arm {

/// Joint values within the limits that reach the goal, those nearest to `near` first, no two alike:
/// at most `most`, of what inverse kinematics makes of `near` and of 64 values drawn at random.
/// None where none was found, which is no proof; what is in the way is not looked at.
/// @throws Error(invalid_parameter) for a robot that `validate` refuses, values that are not within
///         its limits, and a goal that is proven out of its reach or has no such values.
LASIUS_ARM_EXPORT std::vector<JointVector> inverse_kinematics(const Robot& robot, const Goal& goal,
                                                              const JointVector& near, int most = 8,
                                                              std::uint64_t seed = 1);

/// The robot holding something: a link more, that moves with the last joint. The solids are placed
/// in the tip's frame. It may touch the links named, and those that move with the last joint.
/// @throws Error(invalid_parameter) for a name that is no link's, and what `validate` refuses.
LASIUS_ARM_EXPORT Robot holding(Robot robot, const std::string& name, std::vector<Solid> solids,
                                const std::vector<std::string>& may_touch = {});

/// How near to a straight line the tip is to keep, and how far a joint may go between waypoints.
struct TipLineOptions {
  double tolerance = 1e-3;        ///< metres that the tip may be off the line, 1e-6 or more
  double angle_tolerance = 0.01;  ///< radians, 1e-6 or more; pi or more: turned as it likes
  double joint_step = 0.3;        ///< of any joint, radians or metres, 0.001 or more
  StopCondition stop = {};        ///< polled before each waypoint
};

/// A motion of the tip along a line, as far as it goes.
struct TipLine {
  Eigen::MatrixXd joints;           ///< a column each waypoint, the start first
  double reached = 0;               ///< share of the line, 0 .. 1
  Status status = Status::no_path;  ///< solved: all of it; limit, interrupted: told to stop
  Limit limit = Limit::none;        ///< which one ended it
  std::string error = {};           ///< why it ends before its end, for people
};

/// Straight with the tip from where it is to `goal`, turning evenly about one axis. Between two
/// waypoints, which are on the line, joints go straight: the tip's way is within the tolerance of
/// it by a bound of its acceleration, its frame turned off by no more than the other one, and the
/// sensor calls the motion free. Joint values are continued from waypoint to waypoint, so a line
/// through a singular posture or past a joint's limit ends there: status no_path.
/// @throws Error(invalid_parameter) for a robot that `validate` refuses, a start outside of its
///         limits, a goal that is no pose, and options out of range; what the sensor throws.
LASIUS_ARM_EXPORT TipLine tip_line(const Robot& robot, const Sensor& sensor,
                                   const JointVector& start, const Pose& goal,
                                   const TipLineOptions& options = {});

}  // namespace lasius::arm
