// What a planner checks before it asks the first question.
#pragma once

#include "lasius/arm_sensor.h"

namespace lasius::arm {

/// @throws Error(invalid_parameter) for a clearance below Sensor::kLeastClearance.
void check_clearance(const Sensor& sensor);

/// @throws Error(invalid_parameter) unless it is a number of seconds from 0 up.
void check_duration(double seconds);

}  // namespace lasius::arm
