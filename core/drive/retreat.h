// Somewhere else to be: for a while, or to be gone from where the robot may not be.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius {

/// A walk by moves to the eight neighbours from a cell to one of the 4096 nearest that it leads to,
/// drawn by a random word: last cell first, without the cell itself; empty where there is none.
std::vector<Cell> find_retreat(const Grid& passable, Corners corners, Cell from,
                               std::uint32_t word);

/// The fewest such moves over free cells to one that is wanted, `from` first, which may be blocked;
/// empty where none of the 65536 nearest is.
std::vector<Cell> find_way_out(const Grid& map, Corners corners, Cell from,
                               const std::function<bool(Cell)>& wanted);

}  // namespace lasius
