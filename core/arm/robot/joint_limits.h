// MoveIt's joint_limits.yaml.
#pragma once

#include <map>
#include <string>

namespace lasius::arm {

/// What a file says of a joint; NaN for what it does not say.
struct JointLimits {
  double low, high, velocity, acceleration;
};

/// By the names of joints, factors applied. @throws Error(file_missing, file_broken).
std::map<std::string, JointLimits> read_joint_limits(const std::string& file);

}  // namespace lasius::arm
