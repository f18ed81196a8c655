// Paths of a point among the blocked cells of a grid: sight, straightening, checking.
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
#include "lasius/geometry.h"
#include "lasius/grid.h"
#include "lasius/moves.h"
#include "lasius/stop.h"

namespace lasius {

/// Euclidean length of a polyline, summed from its first vertex; 0 for fewer than two.
LASIUS_EXPORT double path_length(std::span<const Point> path) noexcept;

/// True when the straight segment between the centres of two free cells obeys the rule of the
/// plane. Exact: integer arithmetic on whole bit rows.
LASIUS_EXPORT bool visible(const Grid& grid, Cell a, Cell b) noexcept;

/// Pulls a walk of cells straight, piece by piece: greedy line of sight from the first cell that
/// stops at the first hidden one, the result rasterised, reversed, and the whole repeated until
/// nothing gets shorter (Fan et al. 2004, note 3, as restored).
///   cells  a walk: consecutive cells differ by one king's move or are equal; all free. Where the
///          walk itself squeezes between two diagonal blocks (Corners::allow) that step is kept.
/// Returns the cells at the vertices of the polyline, first and last included. When stopped, the
/// shortest valid polyline so far.
LASIUS_EXPORT std::vector<Cell> straighten(const Grid& grid, std::span<const Cell> cells,
                                           const StopCondition& stop = {});

/// The same, then pulled tight: pieces of sight end where sight ends, not where the path has to
/// bend. Around each corner of the taut string (see `tauten`) the polyline bends in at most two of
/// the four cells there, the shortest way of all; vertices are left out or moved by a cell, and
/// pieces pulled again, as long as that shortens it. Where the walk squeezes, as `straighten`.
LASIUS_EXPORT std::vector<Cell> tighten(const Grid& grid, std::span<const Cell> cells,
                                        const StopCondition& stop = {});

/// Shortest path of the homotopy class of a valid polyline: every inner vertex of the result is a
/// corner of a blocked cell that the path bends around. First and last vertex are kept. Exact:
/// vertex by vertex, b of a, b, c is replaced by the convex chain of the corners inside triangle
/// abc, in integers, until every vertex is taut; a locally shortest path is the shortest one of
/// its class.
///   path     vertices at multiples of 0.5, valid under the rule
///   corners  with Corners::allow the path may squeeze between diagonal blocks, and is kept there
/// When stopped, a valid path no longer than the input. @throws Error(invalid_parameter) if the
/// path is not valid.
LASIUS_EXPORT std::vector<Point> tauten(const Grid& grid, std::span<const Point> path,
                                        Corners corners = Corners::forbid,
                                        const StopCondition& stop = {});

/// Why a polyline breaks the rule of the plane (segment and cell named), or nothing if it obeys.
/// Exact. Vertices must be multiples of 0.5 (cell centres, lattice points) inside the map: any
/// other one is a fault.
/// With Corners::allow squeezes between diagonal blocks are no fault; the other two rules agree.
LASIUS_EXPORT std::optional<std::string> path_fault(const Grid& grid, std::span<const Point> path,
                                                    Corners corners = Corners::forbid);

}  // namespace lasius
