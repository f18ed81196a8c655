// OMPL's RRT-Connect for arms, in joint space.
#pragma once

#include <cstdint>
#include <functional>

#include "lasius/arm/sensor.h"

namespace lasius::peers {

struct JointTrial {
  bool solved = false;
  double seconds = 0;           ///< to the first path; all of them without one
  std::int64_t positions = 0;   ///< that the sensor was asked about, until the first path
  std::int64_t motions = 0;     ///< that the sensor was asked about, until the first path
  double shortened_travel = 0;  ///< joint travel after shortcutting until `seconds_in_all`
};

/// What is free, as a planner asks.
struct JointChecks {
  std::function<bool(const arm::JointRef&)> position;
  std::function<bool(const arm::JointRef&, const arm::JointRef&)> motion;
};

/// One run of at most `cap_seconds` from joint values to a position of the tip, by any posture:
/// goal states come from inverse kinematics (damped least squares from random values) as long as
/// the planner asks for more. What is free the sensor says, as it does to our planners. Parameters
/// are OMPL's own. PathSimplifier then has what is left of `seconds_in_all`, and one pass at least.
JointTrial run_rrt_connect(const arm::Robot& robot, const arm::Sensor& sensor,
                           const arm::JointVector& start, const Eigen::Vector3d& goal,
                           double cap_seconds, double seconds_in_all, std::uint32_t seed);

/// The same to one posture, in processor time; PathSimplifier has `more_seconds` for itself.
JointTrial run_rrt_connect(const arm::Robot& robot, const JointChecks& checks,
                           const arm::JointVector& start, const arm::JointVector& goal,
                           double cap_seconds, double more_seconds, std::uint32_t seed);

}  // namespace lasius::peers
