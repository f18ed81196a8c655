// A vehicle's drive through a world that is not as the map has it, and that changes: simulated.
#pragma once

#include <vector>

#include "lasius/drive/drive.h"
#include "lasius/export.h"
#include "lasius/vehicle/navigator.h"

namespace lasius::vehicle {

/// How a drive went. `track` has the cells of the reference point; `length` and `cost` are of the
/// moves, as Navigator::cost has them, cusps left out. Status::no_path where the lattice has no way
/// on what is known, nor on what is there: not proven.
struct DriveResult : lasius::DriveResult {
  std::vector<Pose> poses;     ///< at each tick, the start first
  std::vector<Segment> moves;  ///< of each tick in which it moved
  int goal = -1;               ///< index of that at which it has arrived, else -1
};

/// Drives as lasius::drive() drives a robot, but from pose to pose: in each tick one motion of one
/// curvature and gear, by at most a cell, or a turn in place by which no point of the footprint
/// moves farther. It makes none whose sweep meets anything in the world as it is at that tick: what
/// bars it is felt, and planned around. What would block a cell that it covers, or has swept in its
/// last move, waits. It sees from the cell of its reference point; what it covers is free.
///
/// Without a way, and while obstacles move, it drives aside every 16 ticks by a motion drawn at
/// random.
/// @param goals  as in Request; it has arrived where a way ends
/// @param navigator  `doubt_after` means nothing here: a drive doubts by what is seen
/// @throws Error(invalid_parameter) as lasius::drive() and Navigator
LASIUS_EXPORT DriveResult drive(const Grid& map, const Grid& truth, const Vehicle& vehicle,
                                const Pose& start, std::vector<Pose> goals,
                                const Changes& changes = {}, const DriveOptions& options = {},
                                const NavigatorOptions& navigator = {});

}  // namespace lasius::vehicle
