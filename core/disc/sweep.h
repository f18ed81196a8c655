// Whether a disc on its way meets blocked cells, from the bitmap alone.
#pragma once

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::disc {

/// Does an open disc whose centre goes straight from a to b meet no blocked cell and nothing of
/// the outside? Exact up to rounding. What it sweeps of a row of cells is convex: the columns from
/// its leftmost to its rightmost point, which must all be free. Rows from `a` on: what hides much
/// is near. Both ends lie on the map.
bool sweeps_clear(const Grid& grid, Point a, Point b, double radius) noexcept;

/// The same of a centre that goes around a lattice point, on its circle and in one quadrant, at the
/// distance of the radius. Beside the discs at both ends, which are not looked at here, that sweeps
/// the sector of twice the radius.
/// @param slack  so much less is looked at, in cells: from `centre`, which the disc touches, and at
///               the far side
bool turns_clear(const Grid& grid, Point centre, Point from, Point to, double radius,
                 double slack) noexcept;

}  // namespace lasius::disc
