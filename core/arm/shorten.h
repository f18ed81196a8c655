// A way with what it can do without left out, before a motion is made of it.
#pragma once

#include <functional>
#include <vector>

#include "core/arm/counted_sensor.h"

namespace lasius::arm {

using Waypoints = std::vector<JointVector>;

/// The columns, none like the one before. @throws Error(invalid_parameter) outside of joint limits.
Waypoints waypoints_of(const Robot& robot, const Eigen::Ref<const Eigen::MatrixXd>& waypoints);

/// How far it is from one to the other: joint travel, or seconds at full speed where `quick`.
double far(const Robot& robot, bool quick, const JointVector& a, const JointVector& b);

/// What `shortcut` and `shortcuts` of the options leave.
Waypoints shorter_way(const Robot& robot, const TrajectoryOptions& options, Waypoints way,
                      CountedSensor& counted);

/// The same by random shortcuts that make `seconds`, what a way takes, less.
Waypoints quicker_way(const Robot& robot, const TrajectoryOptions& options, Waypoints way,
                      CountedSensor& counted,
                      const std::function<double(const Waypoints&)>& seconds);

}  // namespace lasius::arm
