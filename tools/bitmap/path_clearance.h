// How far a path is from what is blocked.
#pragma once

#include <vector>

#include "lasius/grid/clearance.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::tool {

/// Farther than this, in cells, counts as this.
inline constexpr int kMostClearance = 64;

/// Distance from a point to the nearest blocked cell's square or the outside, at most `most`.
double distance_to_blocked(const Grid& grid, Point at, double most = kMostClearance);

/// The same at even distances along a path, both ends among them.
struct ClearanceAlong {
  static constexpr int kMostSamples = 600;
  double step = 0;  ///< cells along the path
  std::vector<double> values;
};
/// Precondition: the path has a point, and `length` is its length.
ClearanceAlong clearance_along(const Grid& grid, const std::vector<Point>& path, double length);

}  // namespace lasius::tool
