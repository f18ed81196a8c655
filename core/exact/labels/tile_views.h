// For each tile of cells the corners that they see.
#pragma once

#include "core/exact/corner_graph.h"
#include "core/exact/labels/corner_labels.h"
#include "lasius/grid.h"
#include "lasius/stop.h"

namespace lasius::exact {

/// Fills tiles, live, dead and masks of labels that have the rest. The same for any number of
/// threads; incomplete when stopped.
void list_tiles(const Grid& grid, const CornerGraph& graph, int threads, const StopCondition& stop,
                LabelArrays& labels);

}  // namespace lasius::exact
