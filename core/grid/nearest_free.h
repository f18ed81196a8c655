// The free cell nearest to a place.
#pragma once

#include <optional>

#include "core/base/poller.h"
#include "lasius/geometry.h"
#include "lasius/grid.h"

namespace lasius {

/// The free cell nearest to `c`, which may lie outside (Euclidean, ties to the smaller row, then
/// column); nothing where the map has none, or when stopped.
std::optional<Cell> nearest_free(const Grid& grid, Cell c, Poller& poller);

}  // namespace lasius
