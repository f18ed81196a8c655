// Meshes named by other files.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lasius/arm/robot.h"
#include "lasius/base/error.h"

namespace lasius::arm {

/// Triangles that the meshes of one robot or scene may have in all, as the largest that is read.
inline constexpr std::size_t kMostTriangles = 5'400'000;

/// Adds a warning where a mesh that nothing scales is longer than `most` metres: it is likely to be
/// in millimetres.
void warn_of_size(const Triangles& mesh, const std::string& file, double most,
                  std::vector<std::string>& warnings);

/// Where the mesh `name` is, its path relative to that of the file that names it.
std::string mesh_path(const std::string& file, const std::string& name);

/// Where a mesh of a URDF file is; `name`: a path, file://PATH or package://NAME/PATH. @throws
/// Error(file_unsupported) at `place` for another scheme and for a package that is not known.
std::string mesh_path(const Error::Place& place, const std::string& name,
                      const std::map<std::string, std::string>& packages);

}  // namespace lasius::arm
