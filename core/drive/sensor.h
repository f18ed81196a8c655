// What a robot sees of the world.
#pragma once

#include <functional>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// Cells that are not as they were known, by what they are.
struct News {
  std::vector<Cell> blocked, free;
};

/// Sets in `walls` the blocked cells that the robot sees, see sense().
void mark_walls_in_sight(const Grid& world, Cell robot, double range, Grid& walls);

/// Blocked where one of two maps of the same size is.
Grid walls_of_both(const Grid& a, const Grid& b);

/// The blocked cells of `walls` that are in neither of two other maps, `b` null for none.
std::vector<Cell> walls_without(const Grid& walls, const Grid& a, const Grid* b);

/// Which cells the robot covers.
struct Body {
  std::function<bool(Cell)> covers;
  double reach;  ///< no cell that it covers has its centre farther from that of the robot's
};

/// The cells whose centre is at most `range` cells from the robot's and that it sees, and those
/// that it covers, be they farther, as far as they are not as `known` has them. It sees a free cell
/// where there is sight from centre to centre, a blocked one where there is sight to a free cell at
/// one of its edges.
void sense(const Grid& world, const Grid& known, Cell robot, double range, const Body& body,
           News& news);

}  // namespace lasius
