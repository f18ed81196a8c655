// What a robot sees of the world.
#pragma once

#include <vector>

#include "core/drive/edited_map.h"
#include "lasius/geometry.h"
#include "lasius/grid.h"

namespace lasius {

/// Cells that are not as they were known, by what they are.
struct News {
  std::vector<Cell> blocked, free;
};

/// True when a cell's centre is at most `range` cells from the robot's.
inline bool in_range(Cell robot, Cell cell, double range) noexcept {
  const double dx = cell.x - robot.x, dy = cell.y - robot.y;
  return dx * dx + dy * dy <= range * range;
}

/// True when a robot in a free cell sees another, whatever the range: a free one where there is
/// sight from centre to centre, a blocked one where there is sight to a free cell at one of its
/// edges.
bool sees(const Grid& world, Cell robot, Cell cell) noexcept;

/// The cells within `range` cells of the robot that it sees, and those that it covers, as far as
/// they are not as `known` has them.
void sense(const Grid& world, const Grid& known, Cell robot, double range, const Growth& robot_disc,
           News& news);

}  // namespace lasius
