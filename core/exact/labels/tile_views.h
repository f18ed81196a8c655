// For each tile of cells the corners that they see.
#pragma once

#include "core/exact/labels/corner_labels.h"
#include "core/exact/labels/taut_graph.h"
#include "lasius/grid.h"
#include "lasius/stop.h"

namespace lasius::exact {

/// What a corner that a tile's cells see takes at most, in bytes, once all are listed.
constexpr std::int64_t kTileCornerBytes = sizeof(TileCorner) + sizeof(std::uint64_t);

/// Fills tiles, live, dead and masks. The same for any number of threads; incomplete when stopped,
/// and where tiles would see more than `most` corners, all told: then it ends early.
HubsEnd list_tiles(const Grid& grid, const TautGraph& graph, std::int64_t most, int threads,
                   const StopCondition& stop, LabelArrays& labels);

}  // namespace lasius::exact
