// What robots and obstacles are made of, as the arithmetic wants it.
#pragma once

#include "core/arm/robot/vec3.h"
#include "lasius/arm/robot.h"

namespace lasius::arm {

/// Around the segment from a point to the one `way` from there.
Solid capsule(Vec3 from, Vec3 way, double radius);

/// No point of it is further than this from the origin of the frame that it is in.
double extent(const Solid& solid);

}  // namespace lasius::arm
