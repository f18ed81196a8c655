// Pictures of an arm's motion.
#pragma once

#include <string>

#include "tools/arm/arm_answer.h"

namespace lasius::tool {

/// Three views (from above, the front and the side) of obstacles, arm and tip's path, the joints'
/// curves in time, and the convergence. @throws Error(output_failed).
void write_arm_picture(const std::string& file, const ArmCommand& command, const ArmAnswer& answer);

}  // namespace lasius::tool
