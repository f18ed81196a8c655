// Pictures of an arm's motion.
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "tools/arm/arm_answer.h"

namespace lasius::tool {

/// The part of space that all views show: all of the arm in poses of its motion, its way and goals,
/// and obstacles that are near.
Eigen::AlignedBox3d bounds_of(const ArmAnswer& answer);

/// What ran on what.
std::string arm_title(const ArmCommand& command, const ArmAnswer& answer);

/// Three views (from above, the front and the side) of obstacles, arm and tip's path, the joints'
/// curves in time, and the convergence. @throws Error(output_failed).
void write_arm_picture(const std::string& file, const ArmCommand& command, const ArmAnswer& answer);

}  // namespace lasius::tool
