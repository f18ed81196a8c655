// Paths that are to be judged: tables of points and poses, saved results.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lasius/path/path.h"
#include "lasius/vehicle/motion.h"
#include "tools/bitmap/map_file.h"

namespace lasius::tool {

/// Places no farther apart, in cells, are one but for rounding.
inline constexpr double kOnePlace = 1e-3;

/// A path as a file tells it.
struct PathFile {
  std::string file;
  std::vector<Point> points = {};               ///< its vertices
  std::vector<double> yaws = {};                ///< with a column yaw: one a point, else empty
  std::vector<double> curvatures = {};          ///< with a column kappa, likewise
  bool metres = false;                          ///< all of these in the map's frame, else in cells
  bool metres_of_map = false;                   ///< likewise, of a map that has a frame
  lasius::Curve curve = {};                     ///< of a disc's result, in cells
  std::vector<vehicle::Segment> segments = {};  ///< of a vehicle's result, in cells
  // Of a result, what it was planned with.
  std::optional<vehicle::Vehicle> vehicle = {};  ///< in cells
  double radius = 0;                             ///< cells
  bool unknown_free = false;
  bool squeezes = false;  ///< --corners allow
};

/// Reads
///   .json   a result of `plan`, `drive` or `tour`: its segments, its curve or its path; of a tour
///           all legs as one path
///   .yaml   a nav_msgs/Path
///   others  a table whose header names x and y (or x_m and y_m: metres) and perhaps yaw and kappa
///           among others, split at commas, tabs or blanks
/// @throws Error(file_missing, file_broken) naming the file and the line, or the byte and the key;
/// UsageError for a result without a path
PathFile read_path(const std::string& file, Frame frame);

/// The path in cells of a map. Precondition: a frame, of a path in metres.
std::vector<Point> points_of(const PathFile& path, const LoadedMap& map);
/// Likewise, where it has yaws.
std::vector<vehicle::Pose> poses_of(const PathFile& path, const LoadedMap& map);
/// Likewise, where it has them.
std::vector<double> curvatures_of(const PathFile& path, const LoadedMap& map);

}  // namespace lasius::tool
