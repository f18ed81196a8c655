// What planners check before they ask the first question, and say of the motion that they made.
#pragma once

#include "lasius/arm/plan.h"

namespace lasius::arm {

/// @throws Error(invalid_parameter) for a clearance below Sensor::kLeastClearance.
void check_clearance(const Sensor& sensor);

/// @throws Error(invalid_parameter) unless it is a number of seconds from 0 up.
void check_duration(double seconds);

/// Makes the motion part of a result that has joints, and measures travel along it; where it is
/// empty, since none was asked for, along the joints. How it ended counts where the way is solved.
void take_motion(const Robot& robot, Timing timing, TrajectoryResult made, Result& result);

}  // namespace lasius::arm
