// The shortest path of the whole world: A* over the corners that are seen, region by region.
#pragma once

#include <vector>

#include "core/polygon/route.h"
#include "lasius/base/stop.h"

namespace lasius::polygon {

struct ShortestPath {
  std::vector<Point> path;  ///< empty where stopped
  double length = 0;
  double lower_bound = 0;  ///< no path is shorter; the length where it was found
  StopCondition::Cause cause = StopCondition::Cause::none;
};

/// Precondition: start and goal lie in one piece of free space.
///
/// A shortest path bends only at corners with an angle of free space above 180 degrees. What a
/// corner sees is found by following the cone of its sight through the free lines: every side of a
/// cone is a ray through a corner, so all is decided in integers. Lengths are compared as computed.
ShortestPath shortest_path(const Regions& regions, const Place& start, const Place& goal,
                           const StopCondition& stop);

}  // namespace lasius::polygon
