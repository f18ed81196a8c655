// A disc's path pulled taut by its sight.
#pragma once

#include <vector>

#include "core/disc/disc_space.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"

namespace lasius {

/// Shortens a polyline that keeps a disc's radius, and keeps its ends. In turn each vertex slides
/// towards the next one as far as the one before sees it, from either end, and is cut off as deep
/// as the radius lets it be: so it nears the segments and arcs of its class's shortest path. When
/// stopped, as far as it came.
void tighten(const disc::DiscSpace& space, const StopCondition& stop, std::vector<Point>& path);

}  // namespace lasius
