// Obstacles grown, and the boundary shrunk, by the robot's margin; in grid units.
#pragma once

#include <vector>

#include "core/polygon/arcs.h"
#include "core/polygon/world/geos.h"
#include "lasius/polygon/plan.h"

namespace lasius::polygon {

/// Obstacles grown and the boundary shrunk by the margin, in grid units.
struct Grown {
  Geos::Geometry obstacles;
  Geos::Geometry boundary;  ///< its inside, perhaps in several pieces, or nothing
};

/// Preconditions: valid polygons that do not overlap, one for the boundary, without its holes;
/// walls of two distinct points or more; a margin above 0. `tangents` are those of round joins.
Grown grow(const Geos& geos, Geos::Geometry obstacles, const std::vector<Ring>& walls,
           const Ring& boundary, double margin, const GrowOptions& options, Tangents tangents);

}  // namespace lasius::polygon
