// Neighbourhoods: the moves of an ant on a grid.
#pragma once

#include <array>
#include <cstdint>

namespace lasius::kernels {

inline constexpr int kMaxMoves = 32;
inline constexpr int kMaxReach = 3;  ///< cells that a move goes at most, along x or y
inline constexpr int kMaxSwept = 6;  ///< cells that a move sweeps at most, its ends not counted

enum class Neighbourhood {
  four,            ///< along x or y
  eight,           ///< all around
  sixteen,         ///< the 8 directions at 1 and 2 cells
  sixteen_knight,  ///< 8 and the knight's moves
  twenty_four,     ///< all of the 5 x 5 square
  thirty_two,      ///< 24 and the 8 directions at 3 cells
};

/// A difference of cells.
struct Offset {
  std::int8_t dx = 0;
  std::int8_t dy = 0;
  friend constexpr bool operator==(Offset, Offset) = default;
};

/// One move and what must be free for it besides its ends.
struct Move {
  Offset to;
  double length = 0;
  int swept_count = 0;
  /// Cells whose interior the move crosses, in order of the way.
  std::array<Offset, kMaxSwept> swept{};
  int corner_count = 0;
  /// Lattice points that it crosses on a diagonal: the two cells beside each.
  std::array<std::array<Offset, 2>, kMaxReach> corners{};
};

/// All moves of a neighbourhood in scan order: row by row, left to right.
struct Moves {
  int count = 0;
  std::array<Move, kMaxMoves> move{};

  const Move& operator[](int k) const noexcept { return move[k]; }
};

/// Whole-number arithmetic only. sqrt gives the lengths.
Moves moves_of(Neighbourhood neighbourhood) noexcept;

}  // namespace lasius::kernels
