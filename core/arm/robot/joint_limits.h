// MoveIt's joint_limits.yaml.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lasius::arm {

/// What a file says of a joint, in radians or metres and seconds; NaN for what it does not say.
struct JointLimits {
  double low, high, velocity, acceleration, jerk;
};

struct JointLimitsFile {
  std::map<std::string, JointLimits> joints;  ///< by their names, factors applied
  double velocity = 1, acceleration = 1;      ///< factors of what the file leaves to others
};

/// @throws Error(file_missing, file_broken) with the line, also for a joint that is not among
/// these.
JointLimitsFile read_joint_limits(const std::string& file,
                                  const std::vector<std::string_view>& joints);

}  // namespace lasius::arm
