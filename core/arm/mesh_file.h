// Meshes named by other files.
#pragma once

#include <string>

#include "lasius/arm_robot.h"

namespace lasius::arm {

/// Reads the STL file `name`, its path relative to that of the file that names it.
/// @throws as read_stl.
Triangles read_mesh(const std::string& file, const std::string& name);

}  // namespace lasius::arm
