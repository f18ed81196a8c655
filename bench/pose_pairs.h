// Pairs of poses that a vehicle is to go between.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "lasius/grid/map_io.h"
#include "lasius/vehicle/space.h"

namespace lasius::bench {

using PosePairs = std::vector<std::pair<vehicle::Pose, vehicle::Pose>>;

/// A line x y yaw x y yaw each, in cells. @throws Error(file_broken)
PosePairs read_pose_pairs(const std::filesystem::path& file);

/// The nodes of a route graph (GeoJSON points, metres), in cells. @throws Error(file_broken)
std::vector<Point> nodes_of_graph(const std::filesystem::path& file, const WorldFrame& frame,
                                  int height);

/// All pairs of the nodes of a route graph, each of which faces the next one of the file, the last
/// one the first. @throws Error(file_broken)
PosePairs pairs_of_graph(const std::filesystem::path& file, const WorldFrame& frame, int height);

/// Free ones, by draw.
PosePairs random_pose_pairs(const vehicle::Space& space, const Grid& grid, int count);

}  // namespace lasius::bench
