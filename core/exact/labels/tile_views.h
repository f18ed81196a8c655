// For each tile of cells the corners that they see.
#pragma once

#include "core/exact/labels/corner_labels.h"
#include "core/exact/labels/taut_graph.h"
#include "lasius/grid.h"
#include "lasius/stop.h"

namespace lasius::exact {

/// Fills tiles, live, dead and masks. The same for any number of
/// threads; incomplete when stopped.
void list_tiles(const Grid& grid, const TautGraph& graph, int threads, const StopCondition& stop,
                LabelArrays& labels);

}  // namespace lasius::exact
