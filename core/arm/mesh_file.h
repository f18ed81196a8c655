// Meshes named by other files.
#pragma once

#include <string>

namespace lasius::arm {

/// Where the mesh `name` is, its path relative to that of the file that names it.
std::string mesh_path(const std::string& file, const std::string& name);

}  // namespace lasius::arm
