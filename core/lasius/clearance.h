// Distance to the nearest obstacle, and obstacles grown by a robot's radius.
#pragma once

#include <cstdint>
#include <vector>

#include "lasius/export.h"
#include "lasius/grid.h"
#include "lasius/stop.h"

namespace lasius {

/// Exact squared Euclidean distances, in half cells, from each cell's centre to the nearest point
/// of a blocked cell's square or of the outside; 0 for blocked cells. Row-major, width x height.
/// (Felzenszwalb & Huttenlocher 2012, in integers.)
struct ClearanceField {
  int width = 0;
  int height = 0;
  std::vector<std::int32_t> squared_half_cells;
  /// Clearance in cells.
  LASIUS_EXPORT double at(Cell c) const noexcept;
};

LASIUS_EXPORT ClearanceField clearance(const Grid& grid);

/// Blocks every cell whose centre lies at most `radius` cells from a blocked cell's square or from
/// the outside. Radius 0 changes nothing. Works in bands, so that memory stays a few rows.
/// @throws Error(invalid_parameter) for a negative or not finite radius.
LASIUS_EXPORT Grid grow_obstacles(const Grid& grid, double radius);

}  // namespace lasius
