// Joint values that reach goals, and whether they are free.
#pragma once

#include "lasius/base/stop.h"
#include "tools/arm/arm_answer.h"

namespace lasius::tool {

/// At most `command.inverse` joint values that reach the goals, the nearest to the start first,
/// with what is nearest there; where all of these touch something, the nearest free one of the
/// others takes the place of the last. The plan's length is the joint travel to the first where any
/// is free, NaN where none is. Its status: solved where one is free; invalid where all that were
/// found touch something, no_path where none was found, or else no goal can be reached; limit and
/// interrupted where `stop` held before all goals were done.
void find_inverse(const ArmCommand& command, const arm::SceneSensor& sensor,
                  const StopCondition& stop, ArmAnswer& answer);

}  // namespace lasius::tool
