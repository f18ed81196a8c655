// Shortest walks on the graph that ants move on: the yardstick of their raw tours.
#pragma once

#include <optional>

#include "lasius/base/stop.h"
#include "lasius/export.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius {

/// Length in cells of the shortest walk from centre to centre by the moves of a neighbourhood under
/// a rule of corners, at most 2^-32 of itself longer than the shortest; nothing where there is
/// none, where an end is blocked or outside, or when stopped.
///
/// A* with a bucket queue (Hart, Nilsson & Raphael 1968; Dial 1969) on lengths in whole 2^-32 of a
/// cell, so that equal lengths compare equal. Memory grows with the part of the map that it visits.
LASIUS_EXPORT std::optional<double> shortest_walk(const Grid& grid, Cell start, Cell goal,
                                                  Neighbours neighbours,
                                                  Corners corners = Corners::forbid,
                                                  const StopCondition& stop = {});

}  // namespace lasius
