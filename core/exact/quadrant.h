// The quadrant on one side of a corner, and the part of it that a rectangle takes up.
#pragma once

#include <algorithm>
#include <cstdint>

#include "kernels/sight/cone.h"

namespace lasius::exact {

/// A path bends at a corner around its block, from one side of it to the other. A side is the
/// closed quadrant beside the block where a path goes on along the block's vertical edge (column)
/// or along its horizontal edge (line); the two are opposite quadrants.
enum Side : std::uint32_t { kColumn = 0, kLine = 1 };

/// The lattice points (x0, y0) to (x1, y1).
struct LatticeBox {
  int x0, y0, x1, y1;
  bool holds(int x, int y) const noexcept { return x >= x0 && x <= x1 && y >= y0 && y <= y1; }
};

/// Directions of a quadrant, in columns along and lines away from its root: those that meet a
/// rectangle of it. All of them, unless told otherwise.
struct QuadrantCone {
  std::int64_t along0 = 0, along1 = 1;
  std::int64_t away0 = 0, away1 = 1;

  bool holds(std::int64_t along, std::int64_t away) const noexcept {
    return !is_steeper(along, away) && !is_flatter(along, away);
  }
  /// Does a direction lie between the quadrant's vertical (horizontal) side and the cone?
  bool is_steeper(std::int64_t along, std::int64_t away) const noexcept {
    return along * away1 < along0 * away;
  }
  bool is_flatter(std::int64_t along, std::int64_t away) const noexcept {
    return along * away0 > along1 * away;
  }
  bool has_line() const noexcept { return away0 == 0; }
  /// Slopes of a scan that covers the cone: through lattice points a column and a line beside it.
  kernels::Fixed left() const noexcept {
    return along0 > 1 ? kernels::fixed(static_cast<int>(along0) - 1) / (away1 + 1) : 0;
  }
  kernels::Fixed right() const noexcept {
    return away0 > 1 ? kernels::fixed(static_cast<int>(along1) + 1) / (away0 - 1)
                     : kernels::kLevelSlope;
  }
};

/// The quadrant around (x, y) towards larger right * x and larger down * y.
struct Quadrant {
  int x, y;
  int right, down;

  std::int64_t along(int to_x) const noexcept { return std::int64_t{right} * (to_x - x); }
  std::int64_t away(int to_y) const noexcept { return std::int64_t{down} * (to_y - y); }

  /// The directions that meet a box; all if it holds the root. False if there are none.
  bool meets(const LatticeBox& box, QuadrantCone& cone) const noexcept {
    const auto [along0, along1] = std::minmax({along(box.x0), along(box.x1)});
    const auto [away0, away1] = std::minmax({away(box.y0), away(box.y1)});
    cone = {std::max<std::int64_t>(along0, 0), along1, std::max<std::int64_t>(away0, 0), away1};
    return along1 >= 0 && away1 >= 0;
  }
};

}  // namespace lasius::exact
