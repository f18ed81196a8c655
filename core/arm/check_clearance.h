// What a planner asks of a sensor before it asks the first question.
#pragma once

#include "lasius/arm_sensor.h"

namespace lasius::arm {

/// @throws Error(invalid_parameter) for a clearance below Sensor::kLeastClearance.
void check_clearance(const Sensor& sensor);

}  // namespace lasius::arm
