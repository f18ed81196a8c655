// Pictures of a plan on a polygon world.
#pragma once

#include <string>

#include "tools/polygon/polygon_answer.h"

namespace lasius::tool {

/// Panels: MAKLINK lines, midpoints and Dijkstra's path; the final path; the convergence. For
/// algorithms without iterations the final path only.
void write_polygon_picture(const std::string& file, const LoadedWorld& world,
                           const PolygonAnswer& answer);

/// All paths of a batch.
void write_paths_picture(const std::string& file, const LoadedWorld& world,
                         const std::vector<std::vector<Point>>& paths, const std::string& caption);

}  // namespace lasius::tool
