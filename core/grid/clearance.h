// Distances to what is blocked, from centres of cells or from whole cells.
#pragma once

#include <optional>

#include "core/base/poller.h"
#include "lasius/clearance.h"

namespace lasius {

enum class ClearanceOf {
  centres,  ///< as clearance() has it
  cells,    ///< from the nearest point of the cell: what a path anywhere in it keeps
};

/// As clearance(); of whole cells 0 beside blocked cells, too. Empty if stopped.
std::optional<ClearanceField> clearance(const Grid& grid, ClearanceOf of, Poller& poller);

}  // namespace lasius
