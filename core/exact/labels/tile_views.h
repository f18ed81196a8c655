// For each tile of cells the corners that they see.
#pragma once

#include "core/exact/labels/corner_labels.h"
#include "core/exact/labels/taut_graph.h"
#include "lasius/base/stop.h"
#include "lasius/grid/grid.h"

namespace lasius::exact {

/// Fills tiles, live, dead and masks. The same for any number of threads; incomplete when stopped,
/// and where they would take more than `most` bytes, 8 for each corner that cells of a tile see and
/// 8 more where not all free ones do: then it ends early.
HubsEnd list_tiles(const Grid& grid, const TautGraph& graph, std::int64_t most, int threads,
                   const StopCondition& stop, LabelArrays& labels);

}  // namespace lasius::exact
