// A path as robots take it: places along it at most so far apart, each with its heading.
#pragma once

#include <span>
#include <vector>

#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/map_io.h"
#include "lasius/path/path.h"
#include "lasius/plan/result.h"

namespace lasius {

/// Where a robot is and where it looks. On a bitmap x and y are continuous cell coordinates, y
/// downwards, and yaw turns from +x towards +y; in a map's frame they are metres, y up.
struct Pose {
  double x = 0;    ///< in cells or metres
  double y = 0;    ///< likewise
  double yaw = 0;  ///< radians, more than -pi and at most pi
  friend bool operator==(const Pose&, const Pose&) = default;
};

/// Poses along a polyline: all its vertices, and between two of them places that divide the piece
/// evenly, into as few parts as are at most `spacing` long. Each looks along its piece, a vertex
/// along the one that begins there, the last along the one that ends there. Of a path without
/// length one pose of yaw 0; of none, none. The same on every machine, bit for bit.
///   spacing  in the path's unit, more than 0
/// @throws Error(invalid_parameter) for another spacing, or one of which the path has more than
/// 10^8 parts.
LASIUS_EXPORT std::vector<Pose> poses(std::span<const Point> path, double spacing);

/// Poses along a disc's curve likewise: of an arc they are on the arc, at most `spacing` apart
/// along it, and look along its tangent. @throws likewise.
LASIUS_EXPORT std::vector<Pose> poses(std::span<const CurvePiece> curve, double spacing);

/// Along an answer's curve, where it has one, else along its path, in cells. @throws likewise.
LASIUS_EXPORT std::vector<Pose> poses(const Result& result, double spacing);

/// A pose on a map of so many rows, in cells, as one of the map's frame: in metres, y up.
LASIUS_EXPORT Pose to_world(const WorldFrame& frame, const Pose& cells, int height) noexcept;

}  // namespace lasius
