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

/// Any point of a map: coordinates as multiples of 2^-44 of a cell.
struct FinePoint {
  std::int64_t x;
  std::int64_t y;
  friend bool operator==(const FinePoint&, const FinePoint&) = default;
};
constexpr std::int64_t kFineCell = std::int64_t{1} << 44;

constexpr FinePoint fine(HalfPoint p) noexcept {
  return {p.x * (kFineCell / 2), p.y * (kFineCell / 2)};
}
/// The nearest one to a point in cells, of [0, 32768] each: the point itself where its coordinates
/// are of few enough bits, as all from 256 on are, else off by at most 2^-45.
FinePoint fine(double x, double y) noexcept;

/// The sign of the turn at b of a path from a to c: 1 from the x axis to the y axis, -1 back, 0 for
/// none. Exact.
int turn_sign(FinePoint a, FinePoint b, FinePoint c) noexcept;

/// `sees` for any two points of the map, as exact.
bool sees_fine(const BitmapView& map, FinePoint a, FinePoint b) noexcept;

/// True when a path from a over the lattice point v to b passes between two diagonal blocks there:
/// on both ways round v blocked cells lie between the two segments.
bool squeezes(const BitmapView& map, HalfPoint a, HalfPoint v, HalfPoint b) noexcept;

/// `sees` between the centres of two cells.
inline bool sees_cell(const BitmapView& map, int ax, int ay, int bx, int by) noexcept {
  return sees(map, {2 * ax + 1, 2 * ay + 1}, {2 * bx + 1, 2 * by + 1});
}

}  // namespace lasius::kernels
