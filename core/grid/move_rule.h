// Which moves exist: a neighbourhood's, under a rule of corners.
#pragma once

#include <algorithm>
#include <cstdlib>

#include "kernels/base/moves.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius {

inline Cell operator+(Cell c, kernels::Offset o) noexcept { return {c.x + o.dx, c.y + o.dy}; }

/// All moves of a neighbourhood in scan order: row by row, left to right. Of a disc's those by a
/// knight's move need the whole 2 x 3 cells, as diagonal ones do the 2 x 2.
inline kernels::Moves moves_of(Neighbours neighbours, bool of_disc = false) noexcept {
  const auto has = [neighbours](int dx, int dy) {
    const int ax = std::abs(dx), ay = std::abs(dy), reach = std::max(ax, ay);
    const bool straight = ax == 0 || ay == 0 || ax == ay;  // one of the 8 directions
    switch (neighbours) {
      case Neighbours::four:
        return ax + ay == 1;
      case Neighbours::eight:
        return reach == 1;
      case Neighbours::sixteen:
        return straight && (reach == 1 || reach == 2);
      case Neighbours::sixteen_knight:
        return reach == 1 || ax * ay == 2;
      case Neighbours::twenty_four:
        return reach == 1 || reach == 2;
      case Neighbours::thirty_two:
        return reach == 1 || reach == 2 || (straight && reach == 3);
    }
    return false;
  };
  kernels::Moves moves;
  for (int dy = -kernels::kMaxReach; dy <= kernels::kMaxReach; ++dy) {
    for (int dx = -kernels::kMaxReach; dx <= kernels::kMaxReach; ++dx) {
      if (!has(dx, dy)) continue;
      kernels::Move& move = moves.move[moves.count++] = kernels::make_move(dx, dy);
      if (!of_disc || std::abs(dx * dy) != 2) continue;
      move.corners[move.corner_count++] = {
          {{static_cast<std::int8_t>(dx), 0}, {0, static_cast<std::int8_t>(dy)}}};
    }
  }
  return moves;
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
