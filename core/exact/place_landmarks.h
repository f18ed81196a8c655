// Where a map's landmarks go, and how far they are from its corners.
#pragma once

#include "core/exact/corner_landmarks.h"
#include "lasius/base/stop.h"
#include "lasius/grid/grid.h"

namespace lasius::exact {

class CornerGraph;

/// Landmarks in the largest region of the map: the first as far as possible from somewhere, each
/// further one as far as possible from those before. None if `stop` said so. The threads change
/// nothing.
///
/// The way to a corner v ends either along an edge of the graph or in the quadrant across from v's
/// block, where no path bends at v. A flood over the graph finds the shortest of the first kind,
/// and what it finds is |L w| for each corner w that such a way bends around. So one look from each
/// corner into that quadrant, at corners and landmarks, finds the shortest of the second kind.
Landmarks place_landmarks(const Grid& grid, const CornerGraph& graph, int threads,
                          const StopCondition& stop);

/// See CornerGraph::detour.
double measure_detour(const CornerGraph& graph);

}  // namespace lasius::exact
