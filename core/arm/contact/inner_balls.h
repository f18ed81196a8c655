// Balls inside of solids: where something is in one of them, the solid is touched for certain.
#pragma once

#include <vector>

#include "core/arm/robot/vec3.h"
#include "lasius/arm/robot.h"

namespace lasius::arm {

struct InnerBall {
  Vec3 centre;  // in the frame of the body
  double radius = 0;
  bool hollow = false;  // in a mesh, of which only the surface is solid
};

/// Few balls that fill most of a solid; none of what is too thin, or is no closed surface.
std::vector<InnerBall> inner_balls(const Solid& solid);

}  // namespace lasius::arm
