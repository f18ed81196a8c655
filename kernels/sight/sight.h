// Line of sight among the blocked cells of a bitmap, exact, on whole words of a row.
//
// Half-cell coordinates make every point that a path bends at an integer: the centre of cell (x, y)
// is (2x + 1, 2y + 1), the lattice point at its top left corner (2x, 2y).
#pragma once

#include <cstdint>

#include "kernels/sight/views.h"

namespace lasius::kernels {

/// A point in half-cell coordinates.
struct HalfPoint {
  int x;
  int y;
  friend bool operator==(const HalfPoint&, const HalfPoint&) = default;
};

/// True when no column of [lo, hi] in a row is blocked. -1 <= lo <= hi <= width.
inline bool row_free(const std::uint64_t* row, int lo, int hi) noexcept {
  const int first = lo >> 6;
  const int last = hi >> 6;
  const std::uint64_t from = ~std::uint64_t{0} << (lo & 63);
  const std::uint64_t to = ~std::uint64_t{0} >> (63 - (hi & 63));
  if (first == last) return (row[first] & from & to) == 0;
  if ((row[first] & from) != 0) return false;
  for (int i = first + 1; i < last; ++i) {
    if (row[i] != 0) return false;
  }
  return (row[last] & to) == 0;
}

/// True when the closed segment between two points of [0, 2 width] x [0, 2 height] enters no
/// blocked cell's interior, has nowhere blocked cells on both its sides, and does not pass between
/// two diagonal blocks at a lattice point inside it. Touching corners and sliding along the edges
/// of blocked cells is allowed. For a == b: true when the point touches a free cell.
///
/// Sides up to 32768 cells; all numbers stay below 2^19. At most 2 words a crossed row, plus the
/// words the segment spans.
bool sees(const BitmapView& map, HalfPoint a, HalfPoint b) noexcept;

/// True when a path from a over the lattice point v to b passes between two diagonal blocks there:
/// on both ways round v blocked cells lie between the two segments.
bool squeezes(const BitmapView& map, HalfPoint a, HalfPoint v, HalfPoint b) noexcept;

/// `sees` between the centres of two cells.
inline bool sees_cell(const BitmapView& map, int ax, int ay, int bx, int by) noexcept {
  return sees(map, {2 * ax + 1, 2 * ay + 1}, {2 * bx + 1, 2 * by + 1});
}

}  // namespace lasius::kernels
