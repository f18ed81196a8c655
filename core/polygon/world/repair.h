// What polygons that are not valid are taken for, when a world is read with repair.
#pragma once

#include <vector>

#include "core/polygon/world/geos.h"

namespace lasius::polygon {

/// A ring encloses what it winds around, whichever way; a polygon is what its outer ring encloses,
/// less what each of its holes does, wherever the holes lie.
struct Repair {
  std::vector<Polygon> areas;  ///< valid; none where nothing is enclosed
  std::vector<Polygon> holes;  ///< of a boundary: obstacles in it, where they are not in `areas`
  /// What has no width and would be lost though it is a wall: spikes of an obstacle that lie
  /// outside of it, of a boundary that lie inside, rings that enclose nothing.
  std::vector<std::vector<Point>> lines;
};

/// Precondition: finite coordinates. @throws Error(invalid_parameter) where GEOS cannot do it.
Repair repaired(const Geos& geos, const Polygon& polygon, bool is_boundary);

}  // namespace lasius::polygon
