// Robots from URDF, read by urdfdom.
#pragma once

#include <string>
#include <string_view>

#include "lasius/arm/robot.h"

namespace lasius::arm {

/// The chain between two links. See read_robot.
Robot parse_urdf(std::string_view text, const std::string& file, const Chain& chain);

}  // namespace lasius::arm
