// A disc that moves from cell to cell, as colonies and robots' walks do.
#pragma once

#include <cmath>

#include "core/disc/arc.h"
#include "core/grid/grow_obstacles.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius::disc {

/// The radii that a DiscSpace can be made for, in cells.
constexpr double kLeastRadius = 0.05;
constexpr double kLargestRadius = 54;

constexpr bool has_space(double radius) noexcept {
  return radius >= kLeastRadius && radius <= kLargestRadius;
}

/// Which cells blocked ones block: those whose centres are not clear; for a radius without a
/// DiscSpace those that have a point that is not.
inline Growth growth(const Grid& grid, double radius) {
  return has_space(radius) ? Growth(grid, radius - kMadeSlack, ClearanceOf::centres)
                           : Growth(grid, radius);
}

/// The rule of corners by which moves between such cells keep the radius.
///
/// What lies between the centres of cells of a 2 x 2 block that are all clear is clear, too: a
/// blocked cell has its least distance to that square at one of its corners. So are moves along
/// rows and columns, and with Corners::forbid diagonal ones. Beside a diagonal move whose side
/// cells are not clear, nothing but a corner on the other diagonal through its middle can be nearer
/// to it than to its ends: k sqrt(2) from the middle, sqrt(2 k^2 + 1/2) from the ends. Where the
/// radius is between these for no whole number k, all diagonal moves keep it.
inline Corners corners(double radius) noexcept {
  const double least = radius - kMadeSlack;
  const double k = std::ceil(least / std::sqrt(2.0)) - 1;  // the largest with k sqrt(2) < least
  return least * least <= 2 * k * k + 0.5 ? Corners::forbid : Corners::allow;
}

}  // namespace lasius::disc
