// Component lasius::arm: all of it.
#pragma once

#include "lasius/arm/generate.h"
#include "lasius/arm/plan.h"
#include "lasius/arm/robot.h"
#include "lasius/arm/sensor.h"
#include "lasius/arm/trajectory.h"
