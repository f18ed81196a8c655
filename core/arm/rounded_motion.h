// A motion along a way, its corners rounded, in the least time.
#pragma once

#include "core/arm/shorten.h"

namespace lasius::arm {

/// All that is not on the way itself was asked about as it is sent. A corner's parabola is halved
/// where it is not free, and after some halvings the arm rests there; `stops` is true where it
/// rests at all of several waypoints. Precondition: at least two waypoints.
Trajectory rounded_motion(const Robot& robot, Waypoints way, CountedSensor& counted, bool& stops);

/// What such a motion takes where all is free, nearly; limits of jerk left out.
double seconds_at_best(const Robot& robot, const Waypoints& way);

}  // namespace lasius::arm
