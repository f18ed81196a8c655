// A walk of cells made a short path: straight over cell centres, or taut around corners.
#pragma once

#include <span>
#include <vector>

#include "lasius/base/stop.h"
#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"

namespace lasius {

/// Straightens a walk piece by piece: greedy line of sight from the first cell that
/// stops at the first hidden one, the result rasterised, reversed, and the whole repeated until
/// nothing gets shorter (Fan et al. 2004, note 3, as restored).
///   cells  a walk: consecutive cells differ by one king's move or are equal; all free. Where the
///          walk itself squeezes between two diagonal blocks (Corners::allow) that step is kept.
/// Returns the cells at the vertices of the polyline, first and last included. When stopped, the
/// shortest valid polyline so far. @throws Error(invalid_parameter) for cells that are no walk.
LASIUS_EXPORT std::vector<Cell> greedy_straighten(const Grid& grid, std::span<const Cell> cells,
                                                  const StopCondition& stop = {});

/// What Polish::straight does: greedy_straighten(), then the pieces are made to end where the path
/// has to bend, not where sight ends. Around each corner of the taut string (see `pull_taut`) the
/// polyline bends in at most two of the four cells there, the shortest way of all; vertices are
/// left out or moved by a cell, and pieces straightened again, as long as that shortens it. Where
/// the walk squeezes, as `greedy_straighten`. @throws likewise.
LASIUS_EXPORT std::vector<Cell> straighten(const Grid& grid, std::span<const Cell> cells,
                                           const StopCondition& stop = {});

/// What Polish::taut does: the shortest path of the homotopy class of a valid polyline. Every inner
/// vertex of the result is a corner of a blocked cell that the path bends around. First and last
/// vertex are kept. Exact: vertex by vertex, b of a, b, c is replaced by the convex chain of the
/// corners inside triangle abc, in integers, until every vertex is taut; a locally shortest path is
/// the shortest one of its class.
///   path     vertices at multiples of 0.5, valid under the rule of the plane (see path.h)
///   corners  with Corners::allow the path may squeeze between diagonal blocks, and is kept there
/// When stopped, a valid path no longer than the input. @throws Error(invalid_parameter) if the
/// path is not valid.
LASIUS_EXPORT std::vector<Point> pull_taut(const Grid& grid, std::span<const Point> path,
                                           Corners corners = Corners::forbid,
                                           const StopCondition& stop = {});

}  // namespace lasius
