// Paths among the blocked cells of a grid: of a point, their length, sight, checking; of a disc,
// their curve.
//
// The rule of the plane: a path may touch corners of blocked cells and slide along their edges; it
// may not enter the interior of a blocked cell, run along a grid line with blocked cells on both
// sides, or squeeze between two diagonally adjacent blocked cells. Outside the grid is blocked.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius {

/// Euclidean length of a polyline, summed from its first vertex; 0 for fewer than two.
LASIUS_EXPORT double path_length(std::span<const Point> path) noexcept;

/// True when the straight segment between the centres of two free cells obeys the rule of the
/// plane. Exact: integer arithmetic on whole bit rows.
LASIUS_EXPORT bool visible(const Grid& grid, Cell a, Cell b) noexcept;

/// Why a polyline breaks the rule of the plane (segment and cell named), or nothing if it obeys.
/// Exact. Vertices must be multiples of 0.5 (cell centres, lattice points) inside the map: any
/// other one is a fault, but for the first and the last, which may be any points of the map (taken
/// to the nearest 2^-44 of a cell).
/// With Corners::allow squeezes between diagonal blocks are no fault; the other two rules agree.
LASIUS_EXPORT std::optional<std::string> path_fault(const Grid& grid, std::span<const Point> path,
                                                    Corners corners = Corners::forbid);

/// A straight piece, or an arc about a corner of a blocked cell with the disc's radius.
struct CurvePiece {
  Point from;         ///< where it begins
  Point to;           ///< and ends
  int turn = 0;       ///< 0: straight; 1: an arc that turns from the x axis to the y axis, -1: back
  Point centre = {};  ///< of an arc
  double angle = 0;   ///< of an arc, in radians, more than 0 and at most pi / 2
  double radius = 0;  ///< of an arc, in cells
  friend bool operator==(const CurvePiece&, const CurvePiece&) = default;
};

/// Pieces from start to goal, each beginning where the one before ends and, but for single points,
/// in its direction.
using Curve = std::vector<CurvePiece>;

}  // namespace lasius
