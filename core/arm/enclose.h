// Capsules around other shapes.
#pragma once

#include <vector>

#include "core/arm/vec3.h"

namespace lasius::arm {

/// Up to four capsules along the longest side that enclose a box of this size at `pose`.
std::vector<Capsule> enclose_box(const Placement& pose, Vec3 size);

}  // namespace lasius::arm
