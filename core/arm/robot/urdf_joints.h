// The joints of a URDF file, and their limits.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/arm/robot/joint_limits.h"
#include "core/arm/robot/urdf_file.h"
#include "core/arm/robot/vec3.h"

namespace lasius::arm {

/// It turns or slides.
bool moves(const urdf::Joint& joint);

/// The tightest of all limits that are given; a thousand either way where there is none.
std::pair<double, double> range_of(const urdf::Joint& joint, const JointLimitsFile& limits);

/// A joint that moves, `at` its frame at value 0; what is assumed of it is added to `notes`.
/// @throws Error at its line where its axis or limits are none.
Joint moving_joint(const urdf::Joint& joint, const Placement& at, const UrdfFile& source,
                   const JointLimitsFile& limits, std::vector<std::string>& notes);

}  // namespace lasius::arm
