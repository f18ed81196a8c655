// Distances to what is blocked, from centres of cells or from whole cells.
#pragma once

#include <optional>

#include "core/base/poller.h"
#include "lasius/grid/clearance.h"

namespace lasius {

enum class ClearanceOf {
  centres,          ///< as clearance() has it
  cells,            ///< from the nearest point of the cell: what a path anywhere in it keeps
  blocked_centres,  ///< from a centre to the nearest blocked cell's; none lies outside
};

/// As clearance(); of whole cells 0 beside blocked cells, too. Of
/// blocked centres at most the greatest value, which is that of 23170 cells. Empty if stopped.
std::optional<ClearanceField> clearance(const Grid& grid, ClearanceOf of, Poller& poller);

}  // namespace lasius
