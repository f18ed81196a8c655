// The free cell nearest to a place.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "core/base/poller.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// The words of a row, valid until the next call.
using RowOfBits = std::function<const std::uint64_t*(int y)>;

/// A cell, which may lie outside, and where in it: from its centre, at most half a cell each way.
struct Spot {
  Cell cell;
  Point aside = {};
};

/// The free cell whose centre is nearest to a spot (ties to the smaller row, then column); nothing
/// where the map has none, or when stopped. With `taken` it is the nearest of those that this
/// takes: it is asked about one cell of each run in a row, since the others are joined to that.
/// `row_of`, if given, has the cells' bits in place of the grid's.
std::optional<Cell> nearest_free(const Grid& grid, Spot spot, Poller& poller,
                                 const std::function<bool(Cell)>& taken = {},
                                 const RowOfBits& row_of = {});

}  // namespace lasius
