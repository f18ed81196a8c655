// Which steps from cell to cell there are.
#pragma once

namespace lasius {

/// When a diagonal step between two free cells is allowed, by its two side cells.
enum class Corners {
  forbid,    ///< both side cells must be free
  one_side,  ///< at least one side cell must be free
  allow,     ///< always
};

/// Moves of an ant. Moves of more than one cell need every cell that they sweep to be free.
enum class Neighbours {
  four,            ///< along x or y
  eight,           ///< all around
  sixteen,         ///< the 8 directions at 1 and 2 cells
  sixteen_knight,  ///< 8 and the knight's moves
  twenty_four,     ///< all of the 5 x 5 square
  thirty_two,      ///< 24 and the 8 directions at 3 cells
};

}  // namespace lasius
