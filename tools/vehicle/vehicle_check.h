// Whether a vehicle's footprint keeps from what is blocked along a path, and whether the vehicle
// can drive it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lasius/vehicle/motion.h"
#include "lasius/vehicle/space.h"
#include "tools/vehicle/disc_check.h"

namespace lasius::tool {

/// Curvatures that a table tells at two poses: one of them, where it jumps there, is of a motion
/// beside that between the poses.
struct TwoCurvatures {
  double from = 0, to = 0;
};
/// The arc, the line or the rotation in place that joins two poses, else the clothoid that has one
/// of the curvatures; nothing where none comes within a thousandth of a cell.
std::optional<vehicle::Segment> motion_between(const vehicle::Pose& from, const vehicle::Pose& to,
                                               const std::optional<TwoCurvatures>& told = {});

/// A path as a vehicle drives it.
struct DrivenPath {
  /// What is driven from a pose to the next: a motion, or nothing where x, y and yaw change in
  /// proportion.
  struct Piece {
    vehicle::Pose from, to;
    std::optional<vehicle::Segment> motion;
  };
  std::vector<Piece> pieces;
  bool sampled = false;      ///< poses of a table, which are rounded; else motions as they are
  double length = 0;         ///< cells
  int assumed_straight = 0;  ///< pieces without a motion
};
/// Of motions, and of poses with the motions that join them; `curvatures`, one a pose or none, are
/// what a table tells.
DrivenPath driven(std::span<const vehicle::Segment> segments);
DrivenPath driven(std::span<const vehicle::Pose> poses, std::span<const double> curvatures);

/// A fault, and the vehicle's pose there.
struct VehicleFault : PathFault {
  vehicle::Pose pose{};
};
/// Where the footprint first meets a blocked square or the outside.
std::optional<VehicleFault> contact_fault(const Grid& grid, const vehicle::Space& space,
                                          const DrivenPath& path);

/// The first motion that the vehicle does not have: sharper than its radius, backwards, in place,
/// aside; or a jump between motions.
std::optional<VehicleFault> motion_fault(const vehicle::Vehicle& vehicle, const DrivenPath& path,
                                         std::span<const double> curvatures);

}  // namespace lasius::tool
