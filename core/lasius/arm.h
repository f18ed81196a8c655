// Component lasius::arm: all of it.
#pragma once

#include "lasius/arm_generate.h"
#include "lasius/arm_plan.h"
#include "lasius/arm_robot.h"
#include "lasius/arm_sensor.h"
#include "lasius/arm_trajectory.h"
