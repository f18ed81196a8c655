// Where a scan of a cone of rays starts, how far it looks, and what it works on.
#pragma once

#include <cstdint>

#include "kernels/sight/scan_bits.h"

namespace lasius::kernels {

/// A slope that crosses every map within one row.
constexpr Fixed kLevelSlope = kOne << 16;

/// How a taut path turns at a corner, seen from the ray that reaches it.
enum class Turn : std::uint8_t {
  onward,    ///< around a block ahead on the near side, towards straight onward
  sideways,  ///< around a block behind on the far side, towards larger u
  back,      ///< from a ray straight onward, around a block behind: towards smaller u
};

/// A corner on a boundary ray that another route reaches sooner than the root does.
struct Rival {
  double length;  ///< of that route
  int u;
  int line;
};

/// The rays through one gap: columns on a line, and columns a row.
struct Interval {
  Fixed left = 0, right = 0;
  Fixed left_slope = 0;
  Fixed right_slope = 0;  ///< at least the left one; of no meaning along a wall
  std::int32_t line = 0;
  bool wall = false;  ///< right is the side of a blocked cell in the row behind
  std::uint8_t left_rival = 0, right_rival = 0;  ///< numbers of rivals, 0: none
};

/// Where a scan starts.
struct ConeFrame {
  BitmapView map;
  int down;  ///< +1: line j is grid line line0 + j; -1: line0 - j
  int line0;
  double depth0;  ///< rows from the root to line 0: 0, or 1/2 for a root in a cell's centre
  Fixed root;     ///< column of the root

  /// The last line with rows behind and ahead: that of the border's row.
  int lines() const noexcept { return down > 0 ? map.height - line0 : line0; }
};

/// The frame of a root (x, y) in half cells, a lattice point or a cell's centre, for columns S * x.
template <int S>
constexpr ConeFrame frame_at(const BitmapView& map, int x, int y, int down) noexcept {
  return {.map = map,
          .down = down,
          .line0 = down > 0 ? (y + 1) >> 1 : y >> 1,
          .depth0 = 0.5 * (y & 1),
          .root = Fixed{S} * x * (kOne / 2)};
}

/// How far a scan looks: a box and a strip, both convex and with the root inside, so that no ray
/// that left them comes back.
struct ConeLimits {
  int last_line;    ///< intervals are not followed past this line
  int last_column;  ///< nor past this column; at most one more than the border that ends rows
  /// On line j the strip reaches from column left0 + j * slope to right0 + j * slope.
  Fixed left0, right0, slope;
};

constexpr int kAllColumns = 1 << 18;  ///< more than any map has, on both sides

/// Limits that leave the whole map in.
template <int S>
constexpr ConeLimits whole_map(const BitmapView& map, int lines) noexcept {
  return {.last_line = lines,
          .last_column = S > 0 ? map.width + 1 : 1,
          .left0 = -fixed(kAllColumns),
          .right0 = fixed(kAllColumns),
          .slope = 0};
}

}  // namespace lasius::kernels
