// The cells of a shortest walk.
#pragma once

#include <vector>

#include "lasius/path/shortest_walk.h"

namespace lasius {

/// The cells of a walk as long as shortest_walk() says, `start` first; empty where there is none,
/// or when stopped.
std::vector<Cell> shortest_walk_cells(const Grid& grid, Cell start, Cell goal,
                                      Neighbours neighbours, Corners corners,
                                      const StopCondition& stop);

}  // namespace lasius
