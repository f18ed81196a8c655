// Vehicles: footprints with a smallest turn, all of it.
#pragma once

#include "lasius/vehicle/drive.h"
#include "lasius/vehicle/motion.h"
#include "lasius/vehicle/navigator.h"
#include "lasius/vehicle/planner.h"
#include "lasius/vehicle/profile.h"
#include "lasius/vehicle/scan.h"
#include "lasius/vehicle/space.h"
#include "lasius/vehicle/stop_when.h"
#include "lasius/vehicle/tour.h"
#include "lasius/vehicle/vehicle.h"
