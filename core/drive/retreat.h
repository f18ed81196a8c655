// Somewhere else to be for a while.
#pragma once

#include <cstdint>
#include <vector>

#include "lasius/geometry.h"
#include "lasius/grid.h"
#include "lasius/moves.h"

namespace lasius {

/// A walk by moves to the eight neighbours from a cell to one of the 4096 nearest that it leads to,
/// drawn by a random word: the last cell first, without the cell itself; empty where there is no
/// other.
std::vector<Cell> find_retreat(const Grid& passable, Corners corners, Cell from,
                               std::uint32_t word);

}  // namespace lasius
