// The moves of an ant on a grid.
#pragma once

#include <array>
#include <cstdint>

namespace lasius::kernels {

inline constexpr int kMaxMoves = 32;
inline constexpr int kMaxReach = 3;  ///< cells that a move goes at most, along x or y
inline constexpr int kMaxSwept = 6;  ///< cells that a move sweeps at most, its ends not counted

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

/// The move by (dx, dy) cells, each at most kMaxReach either way, not both 0. Whole-number
/// arithmetic only, but for sqrt, which gives the length.
Move make_move(int dx, int dy) noexcept;

}  // namespace lasius::kernels
