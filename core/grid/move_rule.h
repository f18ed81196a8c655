// Which moves exist: a neighbourhood's, under a rule of corners.
#pragma once

#include "kernels/base/moves.h"
#include "lasius/grid.h"
#include "lasius/moves.h"

namespace lasius {

inline Cell operator+(Cell c, kernels::Offset o) noexcept { return {c.x + o.dx, c.y + o.dy}; }

inline kernels::Moves moves_of(Neighbours neighbours) noexcept {
  using kernels::Neighbourhood;
  switch (neighbours) {
    case Neighbours::four:
      return kernels::moves_of(Neighbourhood::four);
    case Neighbours::eight:
      return kernels::moves_of(Neighbourhood::eight);
    case Neighbours::sixteen:
      return kernels::moves_of(Neighbourhood::sixteen);
    case Neighbours::sixteen_knight:
      return kernels::moves_of(Neighbourhood::sixteen_knight);
    case Neighbours::twenty_four:
      return kernels::moves_of(Neighbourhood::twenty_four);
    case Neighbours::thirty_two:
      return kernels::moves_of(Neighbourhood::thirty_two);
  }
  return kernels::moves_of(Neighbourhood::eight);
}

/// May a move pass between two cells that touch at a lattice point?
inline bool diagonal_allowed(const Grid& grid, Corners corners, Cell a, Cell b) noexcept {
  if (corners == Corners::allow) return true;
  return grid.free(a) + grid.free(b) >= (corners == Corners::forbid ? 2 : 1);
}

/// Can a move be made from a free cell? Where it leads and all that it sweeps must be free, and the
/// cells beside each lattice point that it crosses as `corners` has it.
inline bool move_exists(const Grid& grid, Corners corners, Cell from,
                        const kernels::Move& move) noexcept {
  if (grid.blocked(from + move.to)) return false;
  for (int i = 0; i < move.swept_count; ++i) {
    if (grid.blocked(from + move.swept[i])) return false;
  }
  for (int i = 0; i < move.corner_count; ++i) {
    const auto& [a, b] = move.corners[i];
    if (!diagonal_allowed(grid, corners, from + a, from + b)) return false;
  }
  return true;
}

}  // namespace lasius
