// What a robot's sensor saw, in metres of the map's frame, as cells of its map: for any Navigator.
#pragma once

#include <span>
#include <vector>

#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/map_io.h"
#include "lasius/path/poses.h"

namespace lasius::vehicle {

/// Ranges around a sensor, as a laser scanner has them (sensor_msgs/LaserScan).
struct Scan {
  lasius::Pose sensor = {};  ///< in the map's frame: metres, y up, radians
  double first_angle = 0;  ///< of the first range from where the sensor looks, radians, |.| <= 100
  double step = 0;         ///< from a range to the next, radians
  double least = 0;        ///< metres; nearer ranges mean nothing
  double most = 0;         ///< metres, above 0: from there on, infinity included, nothing was met
  std::span<const double> ranges = {};  ///< metres; what is no number means nothing
};

/// Cells of a map, each told once and of one kind, by rows.
struct SeenCells {
  std::vector<Cell> free;     ///< that rays passed, and no ray ended in
  std::vector<Cell> blocked;  ///< that rays ended in
};

/// The cells that the rays of a scan crossed and met. A ray ends in the cell that holds the point a
/// hundredth of a cell beyond its range, so that walls whose faces lie on the borders of cells are
/// met from either side. What lies outside the map is left out.
/// @throws Error(invalid_parameter) for a number out of range
LASIUS_EXPORT SeenCells seen_cells(const Scan& scan, const WorldFrame& frame, int width,
                                   int height);

/// The same of points in the map's frame, seen from one; of those farther than `most` metres only
/// the way there is told, as far as `most`.
LASIUS_EXPORT SeenCells seen_cells(Point sensor, std::span<const Point> points, double most,
                                   const WorldFrame& frame, int width, int height);

}  // namespace lasius::vehicle
